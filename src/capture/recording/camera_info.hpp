// Intrinsics in ROS messages, independent of the serialisation.
#pragma once

#include <array>
#include <cstdint>
#include <string_view>
#include <vector>

#include "capture/recording/image_message.hpp"
#include "capture/recording/recording.hpp"

namespace rva {

/// Parses the part of a sensor_msgs/CameraInfo that follows its header.
/// @param bytes RosBytes or CdrBytes, after the header
/// @throws Error when the message ends early; as with_lens()
[[nodiscard]] Intrinsics take_camera_info(auto& bytes, std::string_view source) {
  Intrinsics camera;
  camera.height = possible_side(bytes.template number<std::uint32_t>(), source);
  camera.width = possible_side(bytes.template number<std::uint32_t>(), source);
  const std::string_view model = bytes.text();
  std::vector<double> coefficients;
  for (auto left = bytes.template number<std::uint32_t>(); left > 0; --left)
    coefficients.push_back(bytes.template number<double>());
  std::array<double, 9> k{};
  for (double& number : k) number = bytes.template number<double>();
  camera.fx = k[0];
  camera.cx = k[2];
  camera.fy = k[4];
  camera.cy = k[5];
  return with_lens(camera, model, coefficients, source);
}

}  // namespace rva
