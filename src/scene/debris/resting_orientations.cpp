#include <algorithm>
#include <cmath>

#include "scene/debris/resting.hpp"
#include "scene/solids/convex_hull.hpp"

namespace rva {
namespace {

constexpr double flat_m = 2e-5;  ///< facets whose corners deviate from a plane by no more form one face
constexpr double grip_m = 1e-5;  ///< a body whose centre of mass is nearer to the edge of its face tips over

struct Facet {
  std::array<Eigen::Vector3d, 3> corners;
  Eigen::Vector3d area;  ///< outward normal with a length of twice the facet's area

  /// The solid angle of the facet at the origin (Van Oosterom and Strackee, 1983).
  [[nodiscard]] double solid_angle() const {
    const auto& [a, b, c] = corners;
    const double la = a.norm();
    const double lb = b.norm();
    const double lc = c.norm();
    return 2.0 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
};

struct Plane {
  Eigen::Vector3d normal;
  double height_m;

  [[nodiscard]] bool holds(const Facet& facet) const {
    return std::all_of(facet.corners.begin(), facet.corners.end(), [&](const Eigen::Vector3d& corner) {
      return std::abs(normal.dot(corner) - height_m) <= flat_m;
    });
  }
};

/// The hull's facets, largest first: the plane of a sliver is inaccurate, so slivers must join the face of a
/// large facet.
std::vector<Facet> facets_around(std::span<const Part> parts) {
  std::vector<Eigen::Vector3d> points;
  for (const Part& part : parts) {
    for (const Eigen::Vector3f& vertex : part.mesh.vertices) points.emplace_back(vertex.cast<double>());
  }
  std::vector<Facet> facets;
  for (const auto& [i, j, k] : convex_hull(points)) {
    const Eigen::Vector3d& a = points[i];
    const Eigen::Vector3d& b = points[j];
    const Eigen::Vector3d& c = points[k];
    facets.push_back({{a, b, c}, (b - a).cross(c - a)});
  }
  std::stable_sort(facets.begin(), facets.end(), [](const Facet& one, const Facet& other) {
    return one.area.squaredNorm() > other.area.squaredNorm();
  });
  return facets;
}

/// A body on one face of its hull, whether stable or not; `probability` is not yet normalised: a solid angle.
RestingOrientation standing_on(const Plane& plane, std::span<const Facet> face) {
  RestingOrientation standing{
      .floor_from_body =
          Eigen::Quaterniond::FromTwoVectors(plane.normal, -Eigen::Vector3d::UnitZ()).toRotationMatrix(),
      .support = {},
      .height_m = plane.height_m,
      .probability = 0.0};
  std::vector<Eigen::Vector2d> feet;
  for (const Facet& facet : face) {
    for (const Eigen::Vector3d& corner : facet.corners) {
      feet.emplace_back((standing.floor_from_body * corner).head<2>());
    }
    standing.probability += facet.solid_angle();
  }
  standing.support = convex_hull(std::move(feet));
  return standing;
}

}  // namespace

std::vector<RestingOrientation> resting_orientations(std::span<const Part> parts) {
  std::vector<Facet> facets = facets_around(parts);
  std::vector<RestingOrientation> orientations;
  double total = 0.0;
  for (auto first = facets.begin(); first != facets.end();) {
    const Eigen::Vector3d normal = first->area.normalized();
    const Plane plane{normal, normal.dot(first->corners[0])};
    const auto end = std::stable_partition(first + 1, facets.end(),
                                           [&](const Facet& facet) { return plane.holds(facet); });
    RestingOrientation standing = standing_on(plane, {first, end});
    first = end;
    if (depth_inside(standing.support, Eigen::Vector2d::Zero()) < grip_m) continue;
    total += standing.probability;
    orientations.push_back(std::move(standing));
  }
  for (RestingOrientation& orientation : orientations) orientation.probability /= total;
  std::stable_sort(orientations.begin(), orientations.end(),
                   [](const auto& one, const auto& other) { return one.probability > other.probability; });
  return orientations;
}

}  // namespace rva
