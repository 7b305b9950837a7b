// Checks of a camera that looks at a scene in which nothing moves.
#pragma once

#include <functional>
#include <memory>
#include <optional>

#include "camera/camera.hpp"
#include "core/progress.hpp"
#include "doctor/checkup.hpp"

namespace rva {

/// How a camera is checked.
struct CameraNeeds {
  DoctorOptions options;          ///< frames and limits
  std::optional<double> rate_hz;  ///< to which the camera was set; empty if it was set to none
  bool realsense = false;         ///< whether it should have the firmware of a RealSense
};

/// Opens the camera. @throws Error; UsageError when there is no such kind of camera
using OpensCamera = std::function<std::unique_ptr<Camera>()>;

/// The names of the checks of examine_camera(), in their order.
[[nodiscard]] std::vector<std::string> camera_check_names();

/// Checks "camera", "camera-firmware", "frame-rate", "fill", "noise". Errors of the camera are results.
///
/// Noise is the median over pixels of the standard deviation of disparity over time. The limit of 0.2 px is
/// about the 2 % at 2 m that the data sheet of the D400 series allows; half of it is what good cameras reach.
/// @throws UsageError as `open`; Interrupted
[[nodiscard]] CheckedItems examine_camera(const OpensCamera& open, const CameraNeeds& needs,
                                          const Progress& progress);

}  // namespace rva
