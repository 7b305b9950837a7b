// One side of a simulated inspection, captured as `rva serve` captures it.
#pragma once

#include <cstdint>
#include <filesystem>
#include <optional>
#include <vector>

#include "detect/spatial/spatial_detection.hpp"
#include "geometry/pan_tilt.hpp"
#include "map/view_capture.hpp"
#include "scene/scene.hpp"
#include "sim/sensor/stereo_sensor_options.hpp"
#include "sim/simulated_camera.hpp"

namespace rva {

/// The captures of a simulated robot on one side.
struct RobotSide {
  std::vector<std::filesystem::path> captures;  ///< folders, in the order in which they were taken
  std::vector<PanTilt> rested;                  ///< where the joints really were, which no capture states

  /// The first so many captures. @throws Error when one cannot be read
  [[nodiscard]] Captures open(int count) const;
};

/// How far from the step that it reports a servo may come to rest: as far as it does not notice.
inline constexpr double half_a_step_deg = 0.16;

/// Options of the captures of a simulated robot on one side.
struct RobotSideOptions {
  int captures = 4;                    ///< dithered, above 0
  int frames = 10;                     ///< of each capture, above 0
  double rest_error_deg = 0.0;         ///< as of SimulatedRobotOptions
  bool lamp = false;                   ///< as of ViewCaptureOptions
  bool color = false;                  ///< a colour image with each frame
  std::optional<Baseline> baseline{};  ///< as of ViewCaptureOptions
};

/// A robot with play goes to the scene's view and its dithers, from below (robot/dither.hpp), and each
/// capture is written into a folder of its own (take_views()).
/// @param scene  its stand has the position of the robot's foot, the name of the base, and the view's angles
/// @param folder made; captures of the same arguments are always the same
/// @throws Error when a capture cannot be written; Interrupted
[[nodiscard]] RobotSide take_by_robot(const Scene& scene, const StereoSensorOptions& sensor,
                                      const RobotSideOptions& options, std::uint64_t seed,
                                      const std::filesystem::path& folder);

/// A simulated camera at rest at these angles.
[[nodiscard]] SimulatedCamera camera_at(const Scene& scene, const StereoSensorOptions& sensor,
                                        const PanTilt& joints);

}  // namespace rva
