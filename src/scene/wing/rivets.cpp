#include "scene/wing/rivets.hpp"

#include <array>
#include <cmath>

#include "scene/solids/shapes.hpp"

namespace rva {
namespace {

constexpr double pitch_m = 0.035;
constexpr double radius_m = 0.0025;
constexpr double height_m = 0.0012;
constexpr int segments = 8;

TriangleMesh head() {
  const std::array<Eigen::Vector2d, 3> profile{Eigen::Vector2d(radius_m, 0.0),
                                               Eigen::Vector2d(0.7 * radius_m, 0.7 * height_m),
                                               Eigen::Vector2d(0.0, height_m)};
  return lathe(profile, segments);
}

}  // namespace

TriangleMesh rivet_row(const Eigen::Vector3d& from_m, const Eigen::Vector3d& to_m) {
  const int count = static_cast<int>(std::floor((to_m - from_m).norm() / pitch_m));
  const TriangleMesh rivet = head();
  TriangleMesh row;
  for (int k = 0; k < count; ++k) {
    const Eigen::Vector3d position = from_m + (to_m - from_m) * ((k + 0.5) / count);
    row.append(transformed(rivet, Transform(Eigen::Translation3d(position))));
  }
  return row;
}

}  // namespace rva
