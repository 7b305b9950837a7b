// The straight drop of a body, sampled at its vertices and along vertical lines through it. The lines are
// closer together than the thickness of a wing's sheets; thinner obstacles between them, such as a needle,
// are missed.
#include "scene/debris/resting.hpp"

#include <algorithm>

#include "core/units.hpp"
#include "scene/solids/convex_hull.hpp"

namespace rva {
namespace {

constexpr double pitch_m = 0.0015;
constexpr double contact_m = 0.0005;
/// A downward ray that hits a surface whose normal has a z below this starts inside a solid.
constexpr float upward = -1e-3F;

/// A vertical line through the body, from its underside to its top.
struct Column {
  Eigen::Vector3f underside;
  float length;
};

std::vector<Hit> cast_all(const RayCaster& caster, const std::vector<Ray>& rays) {
  std::vector<Hit> hits(rays.size());
  caster.cast(rays, hits);
  return hits;
}

/// One column of zero length for each vertex, then the columns of a grid.
std::vector<Column> columns_of(const SceneObject& body) {
  std::vector<Column> columns;
  const TriangleMesh mesh = world_mesh(body);
  for (const Eigen::Vector3f& vertex : mesh.vertices) columns.push_back({vertex, 0.0F});

  const Eigen::AlignedBox3d box = bounds(mesh);
  const auto low = static_cast<float>(box.min().z() - pitch_m);
  const auto high = static_cast<float>(box.max().z() + pitch_m);
  std::vector<Ray> up;
  std::vector<Ray> down;
  for (double x = box.min().x() + pitch_m / 2; x < box.max().x(); x += pitch_m) {
    for (double y = box.min().y() + pitch_m / 2; y < box.max().y(); y += pitch_m) {
      const Eigen::Vector2f at = Eigen::Vector2d(x, y).cast<float>();
      up.push_back({{at.x(), at.y(), low}, Eigen::Vector3f::UnitZ()});
      down.push_back({{at.x(), at.y(), high}, -Eigen::Vector3f::UnitZ()});
    }
  }
  const RayCaster caster(
      Scene{.name = {}, .objects = {body}, .traces = {}, .lighting = {}, .stand = {}, .bay = {}});
  const std::vector<Hit> undersides = cast_all(caster, up);
  const std::vector<Hit> tops = cast_all(caster, down);
  for (std::size_t i = 0; i < up.size(); ++i) {
    if (undersides[i].object == Hit::none || tops[i].object == Hit::none) continue;
    columns.push_back({up[i].origin + undersides[i].distance * up[i].direction,
                       high - tops[i].distance - (low + undersides[i].distance)});
  }
  return columns;
}

/// Whether the body intersects something at its start position.
bool is_cut(const RayCaster& surface, const std::vector<Column>& columns) {
  std::vector<Ray> rays;
  for (const Column& column : columns) {
    if (column.length > 0.0F) rays.push_back({column.underside, {0, 0, column.length}});
  }
  std::vector<std::uint8_t> blocked(rays.size(), 0);
  surface.occluded(rays, blocked);
  return std::any_of(blocked.begin(), blocked.end(), [](std::uint8_t is_blocked) { return is_blocked != 0; });
}

/// The height of each column above the surface; empty if any column has nothing below it or starts
/// inside a solid.
std::vector<float> gaps_below(const RayCaster& surface, const std::vector<Column>& columns) {
  std::vector<Ray> rays;
  for (const Column& column : columns) rays.push_back({column.underside, -Eigen::Vector3f::UnitZ()});
  std::vector<float> gaps;
  for (const Hit& hit : cast_all(surface, rays)) {
    if (hit.object == Hit::none || hit.normal.z() < upward) return {};
    gaps.push_back(hit.distance);
  }
  return gaps;
}

std::vector<Eigen::Vector2d> contacts(const std::vector<Column>& columns, const std::vector<float>& gaps,
                                      double travel_m) {
  std::vector<Eigen::Vector2d> points;
  for (std::size_t i = 0; i < columns.size(); ++i) {
    if (gaps[i] - travel_m <= contact_m) points.emplace_back(columns[i].underside.head<2>().cast<double>());
  }
  return points;
}

}  // namespace

std::optional<Transform> put_down(const RayCaster& surface, std::span<const Part> parts,
                                  const RestingOrientation& orientation, double turn_deg,
                                  const Eigen::Vector3d& place_m) {
  SceneObject body{
      .name = "body", .kind = "body", .role = Role::debris, .parts = {parts.begin(), parts.end()}};
  const Eigen::AngleAxisd turn(radians(turn_deg), Eigen::Vector3d::UnitZ());
  body.world_from_object.linear() = turn.toRotationMatrix() * orientation.floor_from_body;
  body.world_from_object.translation() = place_m + orientation.height_m * Eigen::Vector3d::UnitZ();

  const std::vector<Column> columns = columns_of(body);
  if (is_cut(surface, columns)) return std::nullopt;
  const std::vector<float> gaps = gaps_below(surface, columns);
  if (gaps.empty()) return std::nullopt;
  const double travel_m = *std::min_element(gaps.begin(), gaps.end());
  const std::vector<Eigen::Vector2d> support = convex_hull(contacts(columns, gaps, travel_m));
  if (depth_inside(support, place_m.head<2>()) < 0.0) return std::nullopt;
  return Eigen::Translation3d(0, 0, -travel_m) * body.world_from_object;
}

}  // namespace rva
