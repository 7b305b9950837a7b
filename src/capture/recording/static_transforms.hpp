// Transforms between the frames of a robot that do not change, as ROS publishes them on /tf_static.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/transform.hpp"

namespace rva {

/// The pose of one frame in another, as a message states it.
struct StaticTransform {
  std::string parent;                                   ///< name of the frame that coordinates are taken to
  std::string child;                                    ///< name of the frame that they are taken from
  Transform parent_from_child = Transform::Identity();  ///< translation in metres
};

/// The transform between two frames that the transforms connect, over any number of others.
/// @return empty where they do not
[[nodiscard]] std::optional<Transform> transform_between(const std::vector<StaticTransform>& transforms,
                                                         std::string_view to, std::string_view from);

/// A rotation and translation from ROS's seven numbers: x, y, z (metres), then the quaternion x, y, z, w.
/// @throws Error when they are not finite, or the quaternion is not of length 1
[[nodiscard]] Transform transform_from_ros(const std::array<double, 7>& numbers, std::string_view source);

/// Parses a tf2_msgs/TFMessage.
/// @param bytes       RosBytes or CdrBytes
/// @param skip_stamp  skips what precedes the frame's name in a header
/// @throws Error when the message ends early; as transform_from_ros()
[[nodiscard]] std::vector<StaticTransform> take_transforms(auto& bytes, auto&& skip_stamp,
                                                           std::string_view source) {
  std::vector<StaticTransform> transforms;
  for (auto left = bytes.template number<std::uint32_t>(); left > 0; --left) {
    skip_stamp();
    StaticTransform transform;
    transform.parent = bytes.text();
    transform.child = bytes.text();
    std::array<double, 7> numbers{};
    for (double& number : numbers) number = bytes.template number<double>();
    transform.parent_from_child = transform_from_ros(numbers, source);
    transforms.push_back(std::move(transform));
  }
  return transforms;
}

}  // namespace rva
