// Stereo cameras that differ from each other as real ones do.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/sensor/stereo_sensor_options.hpp"

namespace rva {

/// A simulated camera under the name by which the command line selects it.
struct CameraModel {
  std::string_view name;       ///< name on the command line
  StereoSensorOptions sensor;  ///< settings of the sensor
};

/// "d435" is the default; the others have the same optics with another matcher or window (docs/simulator.md).
[[nodiscard]] const std::vector<CameraModel>& camera_models();

/// A random camera. Matcher, window, dots, blur, speckle, noise, misalignment, drift, focal length and
/// baseline are drawn from ranges that data sheets and the literature support (docs/simulator.md). The same
/// seed gives the same camera.
[[nodiscard]] StereoSensorOptions random_camera(std::uint64_t seed);

/// The random camera of this seed with further imperfections of real ones: rectification errors, imagers of
/// unequal sensitivity, dots up to saturation, speckle that persists over small turns, and a bay that yields.
[[nodiscard]] StereoSensorOptions imperfect_camera(std::uint64_t seed);

/// The settings of a camera that the command line names.
/// @param text   the name of a model, or "random:SEED" or "imperfect:SEED" for the camera of that seed
/// @param option name of the option that has this text, for the error
/// @throws OptionError for any other text
[[nodiscard]] StereoSensorOptions camera_model(const std::string& text,
                                               const std::string& option = "camera-model");

/// Returns a function from the seed of a study's inspection to its camera. "random:SEED" and "imperfect:SEED"
/// draw another camera for each inspection; any other model is used for all of them.
/// @throws OptionError of the option `cameras` as camera_model() does
[[nodiscard]] std::function<StereoSensorOptions(std::uint64_t)> camera_of_each(const std::string& text);

/// A short name for tables: "semi-global", "census 9", "correlation 7".
[[nodiscard]] std::string name_of_matcher(const StereoSensorOptions& sensor);

}  // namespace rva
