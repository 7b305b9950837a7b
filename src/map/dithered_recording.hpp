// Records dithered captures: several of one view, a few servo steps apart.
#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "camera/camera.hpp"
#include "core/clock.hpp"
#include "core/progress.hpp"
#include "robot/robot.hpp"

namespace rva {

/// What to record, and around which pose.
struct DitheredRecording {
  PanTilt around;           ///< the joint angles of the first capture
  int captures = 8;         ///< 1 to most_dithers (robot/dither.hpp)
  std::size_t frames = 40;  ///< depth frames of each capture
  bool lamp = false;        ///< infrared images under the lamp, too; the camera must have one
};

/// Moves to each of the dithered poses and records a capture there, in folders dither-00, dither-01, ...
/// @param folder exists and is empty, usually that of an OutputFolder
/// @throws Error when the robot, the camera or the disk fails; UsageError when a pose is beyond the robot's
///         limits; Interrupted
void record_dithered(Camera& camera, Robot& robot, const Clock& clock, const DitheredRecording& recording,
                     const std::filesystem::path& folder, const Progress& progress);

/// The files that the folder may contain, in the form that OutputFolder takes.
[[nodiscard]] std::vector<std::string> dithered_capture_files();

}  // namespace rva
