#include "scene/debris/debris_shapes.hpp"

#include <cmath>
#include <numbers>
#include <utility>

#include "core/units.hpp"
#include "scene/solids/shapes.hpp"
#include "scene/solids/skin.hpp"

namespace rva {

Part part_of(std::string_view material, TriangleMesh mesh) {
  return {std::move(mesh), find_material(material)};
}

TriangleMesh moved(const TriangleMesh& mesh, const Eigen::Vector3d& by) {
  return transformed(mesh, Transform(Eigen::Translation3d(by)));
}

TriangleMesh scaled(TriangleMesh mesh, const Eigen::Vector3d& factors) {
  for (Eigen::Vector3f& vertex : mesh.vertices) {
    const Eigen::Vector3d stretched = vertex.cast<double>().cwiseProduct(factors);
    vertex = stretched.cast<float>();
  }
  return mesh;
}

TriangleMesh turned(const TriangleMesh& mesh, double angle_deg, const Eigen::Vector3d& axis) {
  return transformed(mesh, Transform(Eigen::AngleAxisd(radians(angle_deg), axis)));
}

TriangleMesh turned_solid(std::initializer_list<Eigen::Vector2d> profile_rz, int segments) {
  return lathe({profile_rz.begin(), profile_rz.end()}, segments);
}

TriangleMesh turned_hollow(std::initializer_list<Eigen::Vector2d> loop_rz, int segments) {
  return turned_ring({loop_rz.begin(), loop_rz.end()}, segments);
}

Outline hexagon(double across_flats) {
  const double radius = across_flats / std::numbers::sqrt3;
  return ellipse({0, 0}, radius, radius, 6);
}

Outline arc(const Eigen::Vector2d& center, double radius, double from_deg, double to_deg, int pieces) {
  Outline points;
  for (int i = 0; i <= pieces; ++i) {
    const double angle = radians(from_deg + (to_deg - from_deg) * i / pieces);
    points.emplace_back(center.x() + radius * std::cos(angle), center.y() + radius * std::sin(angle));
  }
  return points;
}

TriangleMesh ribbon(const std::vector<Eigen::Vector3d>& path, const std::vector<Eigen::Vector3d>& normals,
                    const Eigen::Vector3d& across, double width, double thickness) {
  const Eigen::Vector3d side = across * (width / 2);
  std::vector<Ring> rings;
  for (std::size_t i = 0; i < path.size(); ++i) {
    const Eigen::Vector3d up = normals[i] * (thickness / 2);
    rings.push_back({path[i] - side - up, path[i] + side - up, path[i] + side + up, path[i] - side + up});
  }
  return skin(rings);
}

Parts fitted(Parts parts, double largest_extent) {
  Eigen::AlignedBox3d box;
  for (const Part& part : parts) box.extend(bounds(part.mesh));
  const double factor = largest_extent / box.sizes().maxCoeff();
  for (Part& part : parts) part.mesh = scaled(std::move(part.mesh), Eigen::Vector3d::Constant(factor));
  return parts;
}

}  // namespace rva
