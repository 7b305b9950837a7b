#include "evaluate/mechanic.hpp"

#include <algorithm>
#include <cstdint>
#include <vector>

#include "scene/camera_stand.hpp"
#include "scene/debris/debris_catalogue.hpp"
#include "scene/debris/resting.hpp"
#include "scene/drop_zone.hpp"

namespace rva {
namespace {

constexpr double farthest_m = 0.6;

}  // namespace

Mechanic::Mechanic(const Scene& bay)
    : bay_(bay),
      surface_(bay),
      camera_m_(world_from_camera(bay.stand).translation()),
      camera_from_world_(world_from_camera(bay.stand).inverse()) {}

std::optional<SceneObject> Mechanic::put(std::string_view kind, const Eigen::Vector2d& at_m, double turn_deg,
                                         Role role) const {
  SceneObject object;
  object.kind = kind;
  object.role = role;
  object.parts = make_debris(kind, 1);
  const RestingOrientation upright = resting_orientations(object.parts).front();
  const auto pose =
      put_down(surface_, object.parts, upright, turn_deg, {at_m.x(), at_m.y(), default_look_down_m(bay_)});
  if (!pose) return std::nullopt;
  object.world_from_object = *pose;
  if (!lies_inside(bay_, object) || !is_in_view(object)) return std::nullopt;
  return object;
}

// Checks corners of the part's extent, drawn in a little, so that what it stands on does not hide it.
bool Mechanic::is_in_view(const SceneObject& object) const {
  constexpr double half_width = 0.85;  // of the view, at a depth of 1 m
  constexpr double half_height = 0.45;
  constexpr double drawn_in = 0.8;
  const Eigen::AlignedBox3d extent = bounds(world_mesh(object));
  const Eigen::Vector3d middle = extent.center();
  const Eigen::Vector3d middle_seen = seen(middle);
  const Eigen::Vector2d at = middle_seen.hnormalized();
  if (middle_seen.z() < 0.2 || middle_seen.z() > farthest_m || std::abs(at.x()) > half_width ||
      std::abs(at.y()) > half_height)
    return false;
  std::vector<Ray> rays;
  for (const auto corner : {Eigen::AlignedBox3d::BottomLeftFloor, Eigen::AlignedBox3d::BottomRightFloor,
                            Eigen::AlignedBox3d::TopLeftCeil, Eigen::AlignedBox3d::TopRightCeil}) {
    const Eigen::Vector3d towards_m = middle + drawn_in * (extent.corner(corner) - middle);
    rays.push_back({camera_m_.cast<float>(), (towards_m - camera_m_).cast<float>()});
  }
  std::vector<std::uint8_t> blocked(rays.size());
  surface_.occluded(rays, blocked);
  return std::ranges::count(blocked, 1) == 0;
}

}  // namespace rva
