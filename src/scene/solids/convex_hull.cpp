#include "scene/solids/convex_hull.hpp"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>
#include <utility>

#include "core/random.hpp"

namespace rva {
namespace {

using Points = std::span<const Eigen::Vector3d>;
using Triangle = std::array<std::uint32_t, 3>;

// For points on one line or in one plane, rounding decides on which side of a triangle they lie, and the hull
// can get a gap there. Random displacements by up to a millionth of the extent prevent four coplanar points.
std::vector<Eigen::Vector3d> jittered(Points points) {
  Eigen::AlignedBox3d box;
  for (const Eigen::Vector3d& point : points) box.extend(point);
  const double reach = 1e-6 * box.sizes().maxCoeff();
  Random random(1);
  std::vector<Eigen::Vector3d> moved(points.begin(), points.end());
  for (Eigen::Vector3d& point : moved) {
    for (double& coordinate : point) coordinate += random.uniform(-reach, reach);
  }
  return moved;
}

/// Builds a hull point by point.
class GrowingHull {
 public:
  explicit GrowingHull(Points points) : points_(points) {}

  void start(const std::array<std::uint32_t, 4>& corners) {
    const auto [a, b, c, d] = corners;
    for (const Triangle& face :
         {Triangle{a, b, c}, Triangle{a, d, b}, Triangle{b, d, c}, Triangle{c, d, a}}) {
      add_face(face);
    }
  }

  /// Removes the faces that are visible from the point, and adds faces between their rim and the point.
  void add(std::uint32_t point) {
    const auto hidden = [&](const Face& face) { return face.height(points_[point]) <= 0; };
    const auto first_seen = std::partition(faces_.begin(), faces_.end(), hidden);
    if (first_seen == faces_.end()) return;
    std::set<std::pair<std::uint32_t, std::uint32_t>> rim;
    std::for_each(first_seen, faces_.end(), [&](const Face& face) {
      for (std::size_t i = 0; i < 3; ++i) {
        const std::uint32_t from = face.corners[i];
        const std::uint32_t to = face.corners[(i + 1) % 3];
        if (rim.erase({to, from}) == 0) rim.emplace(from, to);
      }
    });
    faces_.erase(first_seen, faces_.end());
    for (const auto& [from, to] : rim) add_face({from, to, point});
  }

  [[nodiscard]] std::vector<Triangle> faces() const {
    std::vector<Triangle> triangles;
    for (const Face& face : faces_) triangles.push_back(face.corners);
    return triangles;
  }

 private:
  struct Face {
    Triangle corners;
    // Outward normal of any length, and the plane's offset; plain numbers, since this dominates the run time.
    double x, y, z, offset;

    [[nodiscard]] double height(const Eigen::Vector3d& p) const {
      return x * p.x() + y * p.y() + z * p.z() - offset;
    }
  };

  void add_face(const Triangle& corners) {
    const Eigen::Vector3d& a = points_[corners[0]];
    const Eigen::Vector3d normal = (points_[corners[1]] - a).cross(points_[corners[2]] - a);
    faces_.push_back({corners, normal.x(), normal.y(), normal.z(), normal.dot(a)});
  }

  Points points_;
  std::vector<Face> faces_;
};

template <typename Measure>
std::uint32_t farthest(Points points, Measure measure) {
  const auto found = std::max_element(points.begin(), points.end(), [&](const auto& one, const auto& other) {
    return measure(one) < measure(other);
  });
  return static_cast<std::uint32_t>(found - points.begin());
}

/// The corners of a large tetrahedron, found greedily, ordered so that its faces point outward.
std::array<std::uint32_t, 4> first_corners(Points points) {
  const std::uint32_t a = farthest(points, [](const auto& p) { return -p.x(); });
  const std::uint32_t b = farthest(points, [&](const auto& p) { return (p - points[a]).squaredNorm(); });
  const Eigen::Vector3d line = points[b] - points[a];
  const std::uint32_t c =
      farthest(points, [&](const auto& p) { return line.cross(p - points[a]).squaredNorm(); });
  const Eigen::Vector3d normal = line.cross(points[c] - points[a]);
  const std::uint32_t d =
      farthest(points, [&](const auto& p) { return std::abs(normal.dot(p - points[a])); });
  if (normal.dot(points[d] - points[a]) > 0) return {a, c, b, d};
  return {a, b, c, d};
}

bool is_flat(Points points, const std::array<std::uint32_t, 4>& corners) {
  const auto [a, b, c, d] = corners;
  const Eigen::Vector3d line = points[b] - points[a];
  const double volume = std::abs(line.cross(points[c] - points[a]).dot(points[d] - points[a]));
  return volume <= 1e-9 * line.norm() * line.squaredNorm();
}

double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

}  // namespace

std::vector<Triangle> convex_hull(Points points) {
  if (points.size() < 4) return {};
  if (is_flat(points, first_corners(points))) return {};
  const std::vector<Eigen::Vector3d> moved = jittered(points);
  GrowingHull hull(moved);
  const std::array<std::uint32_t, 4> started = first_corners(moved);
  hull.start(started);
  for (std::uint32_t i = 0; i < moved.size(); ++i) {
    if (std::find(started.begin(), started.end(), i) == started.end()) hull.add(i);
  }
  return hull.faces();
}

// Andrew's monotone chain: the lower side from left to right, then the upper one back.
std::vector<Eigen::Vector2d> convex_hull(std::vector<Eigen::Vector2d> points) {
  const auto less = [](const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
    return a.x() < b.x() || (a.x() == b.x() && a.y() < b.y());
  };
  std::sort(points.begin(), points.end(), less);
  points.erase(std::unique(points.begin(), points.end()), points.end());
  if (points.size() < 3) return points;
  std::vector<Eigen::Vector2d> hull;
  for (int side = 0; side < 2; ++side) {
    const std::size_t start = hull.size();
    for (const Eigen::Vector2d& point : points) {
      while (hull.size() >= start + 2 && turn(hull[hull.size() - 2], hull.back(), point) <= 0)
        hull.pop_back();
      hull.push_back(point);
    }
    hull.pop_back();  // the other side starts with it
    std::reverse(points.begin(), points.end());
  }
  return hull;
}

double depth_inside(std::span<const Eigen::Vector2d> polygon, const Eigen::Vector2d& point) {
  if (polygon.size() < 3) return -std::numeric_limits<double>::infinity();
  double depth = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& from = polygon[i];
    const Eigen::Vector2d& to = polygon[(i + 1) % polygon.size()];
    depth = std::min(depth, turn(from, to, point) / (to - from).norm());
  }
  return depth;
}

}  // namespace rva
