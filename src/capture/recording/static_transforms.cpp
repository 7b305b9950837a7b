#include "capture/recording/static_transforms.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.hpp"

namespace rva {

std::optional<Transform> transform_between(const std::vector<StaticTransform>& transforms,
                                           std::string_view to, std::string_view from) {
  std::map<std::string_view, Transform> frame_from{{from, Transform::Identity()}};  // known so far
  for (bool grown = true; grown && !frame_from.contains(to);) {
    grown = false;
    for (const StaticTransform& edge : transforms) {
      const auto parent = frame_from.find(edge.parent);
      const auto child = frame_from.find(edge.child);
      if ((parent == frame_from.end()) == (child == frame_from.end())) continue;
      if (parent == frame_from.end())
        frame_from.emplace(edge.parent, edge.parent_from_child * child->second);
      else
        frame_from.emplace(edge.child, edge.parent_from_child.inverse() * parent->second);
      grown = true;
    }
  }
  const auto found = frame_from.find(to);
  return found == frame_from.end() ? std::nullopt : std::optional(found->second);
}

Transform transform_from_ros(const std::array<double, 7>& numbers, std::string_view source) {
  const Eigen::Quaterniond rotation(numbers[6], numbers[3], numbers[4], numbers[5]);
  const bool finite = std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
  if (!finite || std::abs(rotation.norm() - 1.0) > 1e-3)
    throw Error(std::string(source), "a transform between its imagers is not a rotation and translation",
                "record it again");
  Transform transform = Transform::Identity();
  transform.linear() = rotation.normalized().toRotationMatrix();
  transform.translation() = Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
  return transform;
}

}  // namespace rva
