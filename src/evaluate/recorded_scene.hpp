// Captures of any camera, with their truth.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "detect/spatial/spatial_detection.hpp"
#include "evaluate/judgement.hpp"
#include "geometry/transform.hpp"

namespace rva {

/// An object that was added, in the view of the first final capture.
struct RecordedTarget {
  Target target;           ///< its kind is its name in truth.json
  bool seen_free = false;  ///< at least half of it lies in space that the first initial capture saw as free
};

/// A folder SCENE with captures `initial` and `final`, or `initial0`, `initial1`, ... and `final0`, ..., and
/// the truth of the first final capture: `label.png` (8 bits: 0 structure, else an object's number),
/// `seen.png` (8 bits: 255 where the first initial view saw free space), `truth.json`
/// (`{"objects": {"1": {"name", "depth_m"}}}`) and, if known, `final_from_initial.txt` (4x4, metres).
struct RecordedScene {
  std::string name;                            ///< name of the folder
  std::vector<std::filesystem::path> initial;  ///< folders of the captures before
  std::vector<std::filesystem::path> final;    ///< folders of the captures after
  std::vector<RecordedTarget> targets;         ///< objects that were added
  int width = 0;                               ///< of the depth images, px
  int height = 0;                              ///< of the depth images, px
  /// True transform between the first captures; empty if it is not known.
  std::optional<Transform> final_from_initial;
};

/// Loads the truth and the paths of the captures of one scene.
/// @throws Error if a part is missing or inconsistent with the others
[[nodiscard]] RecordedScene load_recorded_scene(const std::filesystem::path& folder);

/// Loads the folder itself if it is a scene, else all scenes in it, sorted by name.
/// @throws Error if there is none, or as load_recorded_scene() does
[[nodiscard]] std::vector<RecordedScene> load_recorded_scenes(const std::filesystem::path& folder);

/// Opens the first `count` captures.
/// @throws Error if one cannot be read
[[nodiscard]] Captures open_first(const std::vector<std::filesystem::path>& captures, std::size_t count);

}  // namespace rva
