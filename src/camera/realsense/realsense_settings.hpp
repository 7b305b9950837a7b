// Settings of a RealSense camera.
#pragma once

#include <librealsense2/rs.hpp>
#include <map>
#include <string>
#include <vector>

#include "camera/realsense/realsense.hpp"

namespace rva {

/// Applies the options that the sensor supports.
/// @return sentences on options that it lacks, and on values that differ from the requested ones
[[nodiscard]] std::vector<std::string> apply_settings(const rs2::sensor& depth_sensor,
                                                      const RealSenseOptions& options);

/// The values of all options that can be read, by librealsense's names.
[[nodiscard]] std::map<std::string, double> read_settings(rs2::sensor sensor);

}  // namespace rva
