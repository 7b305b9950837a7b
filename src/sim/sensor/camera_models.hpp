// Stereo cameras that differ as real ones do.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "sim/sensor/stereo_sensor_options.hpp"

namespace rva {

struct CameraModel {
  std::string_view name;
  StereoSensorOptions sensor;
};

/// "d435" is the default; the others have its optics and another matcher or window each (docs/simulator.md).
[[nodiscard]] const std::vector<CameraModel>& camera_models();

/// Drawn by chance: matcher, window, dots, blur, speckle, noise, misalignment, drift, focal length and
/// baseline, over ranges that data sheets and the literature support (docs/simulator.md). The same seed gives
/// the same camera.
[[nodiscard]] StereoSensorOptions random_camera(std::uint64_t seed);

/// The same camera with what real ones have besides: errors of rectification, imagers that record unlike
/// amounts of light, dots up to saturation, speckle that stays over small turns, and a bay that gives way.
[[nodiscard]] StereoSensorOptions imperfect_camera(std::uint64_t seed);

/// A model by its name, or of "random:SEED" and "imperfect:SEED" the camera of that seed.
/// @throws UsageError for any other text
[[nodiscard]] StereoSensorOptions camera_model(const std::string& text);

/// The camera of each inspection of a study, by the inspection's seed: "random:SEED" and "imperfect:SEED"
/// draw another for each, any other model is that of all.
/// @throws UsageError as camera_model()
[[nodiscard]] std::function<StereoSensorOptions(std::uint64_t)> camera_of_each(const std::string& text);

/// In a word or two, for tables: "semi-global", "census 9", "correlation 7".
[[nodiscard]] std::string name_of_matcher(const StereoSensorOptions& sensor);

}  // namespace rva
