// Settings of a RealSense camera.
#pragma once

#include <librealsense2/rs.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "camera/realsense/realsense.hpp"

namespace rva {

/// Applies the options that the sensor supports.
/// @return sentences on options that it lacks, and on values that differ from the requested ones
[[nodiscard]] std::vector<std::string> apply_settings(const rs2::sensor& depth_sensor,
                                                      const RealSenseOptions& options);

/// The exposure of the infrared imagers, and what can be set; empty if the sensor lacks one of the settings.
/// @param rate_hz frames per second, which limit the exposure time
[[nodiscard]] std::optional<ExposureControl> read_exposure(const rs2::sensor& depth_sensor, double rate_hz);

/// Sets time and gain, or hands both to the camera.
/// @throws rs2::error when the camera refuses a value
void apply_exposure(const rs2::sensor& depth_sensor, const Exposure& exposure);

/// The values of all options that can be read, by librealsense's names.
[[nodiscard]] std::map<std::string, double> read_settings(rs2::sensor sensor);

}  // namespace rva
