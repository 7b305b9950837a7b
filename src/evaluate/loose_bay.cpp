#include "evaluate/loose_bay.hpp"

#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <string_view>
#include <utility>

#include "core/random.hpp"
#include "evaluate/mechanic.hpp"
#include "evaluate/random_wing.hpp"

namespace rva {
namespace {

constexpr std::array<std::string_view, 3> kinds{"collar-0.36", "collar-0.44", "nut-m6"};
constexpr double moved_m = 0.005;
constexpr double most_turn_deg = 20.0;

// Empty where the part does not come to rest on one surface on both sides.
std::optional<LooseBay> with_part(const Scene& bay, const Mechanic& mechanic, Random& random) {
  const std::string_view kind = kinds.at(random.bits() % kinds.size());
  const Eigen::Vector2d at(random.uniform(bay.bay.min().x(), bay.bay.max().x()), random.uniform(0.25, 0.85));
  const double heading = random.uniform(0.0, 2.0 * std::numbers::pi);
  const double turn_deg = random.uniform(0.0, 360.0);
  const Eigen::Vector2d to = at + moved_m * Eigen::Vector2d(std::cos(heading), std::sin(heading));
  auto before = mechanic.put(kind, at, turn_deg, Role::debris);
  auto after = mechanic.put(kind, to, turn_deg + random.uniform(-most_turn_deg, most_turn_deg), Role::debris);
  if (!before || !after) return std::nullopt;
  const Eigen::Vector3d was = before->world_from_object.translation();
  const Eigen::Vector3d is = after->world_from_object.translation();
  if (std::abs(is.z() - was.z()) > 1e-3) return std::nullopt;
  LooseBay loose{bay, bay, mechanic.seen(was), mechanic.seen(is)};
  before->name = after->name = "loose";
  loose.before.objects.push_back(std::move(*before));
  loose.after.objects.push_back(std::move(*after));
  return loose;
}

}  // namespace

// Bays whose view has no room are drawn again.
LooseBay random_loose_bay(std::uint64_t seed) {
  constexpr int tries = 1000;
  for (std::uint64_t draw = 0;; ++draw) {
    const std::uint64_t of_draw = draw == 0 ? seed : mix(seed, draw);
    const Scene bay = random_wing(of_draw);
    const Mechanic mechanic(bay);
    Random random(mix(of_draw, 0x5AE));
    for (int k = 0; k < tries; ++k) {
      if (auto loose = with_part(bay, mechanic, random)) return std::move(*loose);
    }
  }
}

}  // namespace rva
