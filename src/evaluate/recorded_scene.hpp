// Captures of any camera, with the truth beside them.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "cloud/spatial_detection.hpp"
#include "evaluate/judgement.hpp"
#include "geometry/transform.hpp"

namespace rva {

/// An object that was added, as the first final capture's imager sees it.
struct RecordedTarget {
  Target target;           ///< its kind is its name in truth.json
  bool seen_free = false;  ///< half of it lies where the first initial capture saw free space
};

/// A folder SCENE with captures `initial` and `final`, or `initial0`, `initial1`, ... and `final0`, ..., and
/// of the first final one: `label.png` (8 bits: 0 structure, else an object's number), `seen.png` (8 bits:
/// 255 where the first initial view saw free space), `truth.json` (`{"objects": {"1": {"name", "depth_m"}}}`)
/// and, where it is known, `final_from_initial.txt` (4x4, metres).
struct RecordedScene {
  std::string name;
  std::vector<std::filesystem::path> initial;
  std::vector<std::filesystem::path> final;
  std::vector<RecordedTarget> targets;
  int width = 0;
  int height = 0;
  std::optional<Transform> final_from_initial;
};

/// @throws Error when a part is missing or does not fit
[[nodiscard]] RecordedScene load_recorded_scene(const std::filesystem::path& folder);

/// The folder itself, or all scenes in it, by their names. @throws Error when there is none
[[nodiscard]] std::vector<RecordedScene> load_recorded_scenes(const std::filesystem::path& folder);

/// The first so many captures. @throws Error when one cannot be read
[[nodiscard]] Captures open_first(const std::vector<std::filesystem::path>& captures, std::size_t count);

}  // namespace rva
