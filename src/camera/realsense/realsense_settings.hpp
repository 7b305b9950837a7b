// What a RealSense is set to before it measures.
#pragma once

#include <librealsense2/rs.hpp>
#include <map>
#include <string>
#include <vector>

#include "camera/realsense/realsense.hpp"

namespace rva {

/// Sets what the sensor has of the options.
/// @return sentences on what it took otherwise than asked
[[nodiscard]] std::vector<std::string> apply_settings(const rs2::sensor& depth_sensor,
                                                      const RealSenseOptions& options);

/// Every option that can be read, by librealsense's names.
[[nodiscard]] std::map<std::string, double> read_settings(rs2::sensor sensor);

}  // namespace rva
