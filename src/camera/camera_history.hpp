// Checks of a camera before work, compared with its earlier ones.
#pragma once

#include <filesystem>
#include <nlohmann/json_fwd.hpp>

#include "camera/camera.hpp"
#include "camera/check_standard.hpp"
#include "core/progress.hpp"

namespace rva {

/// A check, how it was judged, and the file to which it was added.
struct JudgedCheck {
  CameraCheck check;              ///< with `fit` as judged
  CameraJudgement judgement;      ///< compared with the earlier checks in the history
  std::filesystem::path history;  ///< file to which it was added
};

/// Records frames of a still scene, compares them with the earlier checks of the same camera, and adds the
/// check to them. A history belongs to a camera, not to a port: its file is named by the serial number, or by
/// the model where the camera has none.
/// @param folder of the histories of all cameras; created where it is missing
/// @param frames number of frames, at least 4
/// @throws Error when the camera or the disk fails, or the history is damaged; UsageError when an option is
///         out of range; Interrupted
[[nodiscard]] JudgedCheck check_and_remember(Camera& camera, const std::filesystem::path& folder,
                                             std::size_t frames, const CheckStandardOptions& options,
                                             const Progress& progress);

/// The check in the format rva-camera-check: each quantity with its limits, whether the camera is fit, and
/// the file of its history.
[[nodiscard]] nlohmann::ordered_json json_of(const JudgedCheck& judged);

}  // namespace rva
