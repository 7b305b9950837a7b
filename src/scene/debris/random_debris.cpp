#include "scene/debris/random_debris.hpp"

#include <algorithm>
#include <numbers>
#include <optional>

#include "core/interrupt.hpp"
#include "core/random.hpp"
#include "scene/debris/debris_catalogue.hpp"
#include "scene/debris/resting.hpp"
#include "scene/drop_zone.hpp"

namespace rva {
namespace {

// Several kinds are tried for each piece: a crowded bay may have no room for a rag, but still for a nut.
constexpr int most_kinds = 20;
constexpr int most_tries = 100;  // for one kind
constexpr double clearance_m = 0.002;

Eigen::AlignedBox2d seen_from_above(const SceneObject& object) {
  const Eigen::AlignedBox3d box = bounds(world_mesh(object));
  const Eigen::Vector2d slack = Eigen::Vector2d::Constant(clearance_m / 2);
  return {box.min().head<2>() - slack, box.max().head<2>() + slack};
}

const RestingOrientation& tumble(const std::vector<RestingOrientation>& orientations, Random& chance) {
  double left = chance.uniform(0, 1);
  for (const RestingOrientation& orientation : orientations) {
    left -= orientation.probability;
    if (left < 0) return orientation;
  }
  return orientations.back();
}

// Places one set of debris in a scene.
class Scattering {
 public:
  Scattering(const RandomDebris& wanted, Scene& scene)
      : wanted_(wanted), scene_(scene), surface_(scene), chance_(mix(wanted.seed, wanted.group)) {
    for (const SceneObject& object : scene.objects) {
      if (object.role == Role::debris) occupied_.push_back(seen_from_above(object));
    }
  }

  /// Returns false if no free position is found.
  [[nodiscard]] bool place_one() {
    for (int kinds = 0; kinds < most_kinds; ++kinds) {
      throw_if_interrupted();
      SceneObject object;
      object.role = Role::debris;
      object.kind = wanted_.kinds[static_cast<std::size_t>(chance_.bits() % wanted_.kinds.size())];
      object.parts = make_debris(object.kind, chance_.bits());
      const std::vector<RestingOrientation> orientations = resting_orientations(object.parts);
      for (int tries = 0; tries < most_tries; ++tries) {
        if (!drop(object, tumble(orientations, chance_))) continue;
        occupied_.push_back(seen_from_above(object));
        scene_.objects.push_back(std::move(object));
        return true;
      }
    }
    return false;
  }

 private:
  [[nodiscard]] bool drop(SceneObject& object, const RestingOrientation& orientation) {
    const double turn_deg = chance_.uniform(0, 360);
    const double x_m = chance_.uniform(wanted_.within.min().x(), wanted_.within.max().x());
    const double y_m = chance_.uniform(wanted_.within.min().y(), wanted_.within.max().y());

    // Most positions already fail the test in the plane, which saves the time of the drop.
    const Eigen::AngleAxisd turn(turn_deg * std::numbers::pi / 180, Eigen::Vector3d::UnitZ());
    object.world_from_object.linear() = turn.toRotationMatrix() * orientation.floor_from_body;
    object.world_from_object.translation() = Eigen::Vector3d(x_m, y_m, wanted_.from_m);
    const Eigen::AlignedBox2d area = seen_from_above(object);
    if (is_beyond_bay(area) || is_occupied(area)) return false;

    const auto pose = put_down(surface_, object.parts, orientation, turn_deg, {x_m, y_m, wanted_.from_m});
    if (!pose) return false;
    object.world_from_object = *pose;
    return lies_inside(scene_, object);
  }

  [[nodiscard]] bool is_beyond_bay(const Eigen::AlignedBox2d& area) const {
    if (scene_.bay.isEmpty()) return false;
    const Eigen::AlignedBox2d bay(scene_.bay.min().head<2>(), scene_.bay.max().head<2>());
    return !bay.contains(area);
  }

  [[nodiscard]] bool is_occupied(const Eigen::AlignedBox2d& area) const {
    return std::any_of(occupied_.begin(), occupied_.end(),
                       [&](const Eigen::AlignedBox2d& other) { return other.intersects(area); });
  }

  const RandomDebris& wanted_;
  Scene& scene_;
  RayCaster surface_;  // the scene before this set: its pieces lie apart and never rest on each other
  Random chance_;
  std::vector<Eigen::AlignedBox2d> occupied_;
};

}  // namespace

int place_at_random(const RandomDebris& wanted, Scene& scene) {
  Scattering scattering(wanted, scene);
  int placed = 0;
  while (placed < wanted.count && scattering.place_one()) ++placed;
  return placed;
}

}  // namespace rva
