#include "scene/debris/lying_direction.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/units.hpp"

namespace rva {

double lying_direction_deg(std::span<const Part> parts, const RestingOrientation& orientation) {
  // Vertices relative to the centre of mass.
  std::vector<Eigen::Vector2d> seen_from_above;
  Eigen::Matrix2d spread = Eigen::Matrix2d::Zero();
  for (const Part& part : parts) {
    for (const Eigen::Vector3f& vertex : part.mesh.vertices) {
      const Eigen::Vector2d point = (orientation.floor_from_body * vertex.cast<double>()).head<2>();
      seen_from_above.push_back(point);
      spread += point * point.transpose();
    }
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d> solver;
  solver.computeDirect(spread);
  Eigen::Vector2d axis = solver.eigenvectors().col(1);

  // The lighter end is farther from the centre of mass.
  const auto [back, front] =
      std::minmax_element(seen_from_above.begin(), seen_from_above.end(),
                          [&](const auto& a, const auto& b) { return axis.dot(a) < axis.dot(b); });
  if (-axis.dot(*back) > axis.dot(*front)) axis = -axis;
  return degrees(std::atan2(axis.y(), axis.x()));
}

}  // namespace rva
