#include "evaluate/random_wing.hpp"

#include <array>
#include <string>
#include <string_view>

#include "core/random.hpp"
#include "sim/scene/debris_catalogue.hpp"
#include "sim/scene/drop_zone.hpp"
#include "sim/scene/random_debris.hpp"
#include "sim/scene/wing_bay.hpp"

namespace rva {
namespace {

// Primer as often as all else: so are wings.
constexpr std::array<std::string_view, 8> coats{"green-primer",       "green-primer",  "green-primer",
                                                "green-primer",       "white-paint",   "matt-grey",
                                                "anodised-aluminium", "bare-aluminium"};

template <typename Choice, std::size_t count>
Choice one_of(const std::array<Choice, count>& choices, Random& random) {
  return choices[random.bits() % count];
}

int whole(int low, int high, Random& random) {
  return low + static_cast<int>(random.bits() % static_cast<std::uint64_t>(high - low + 1));
}

WingBay random_bay(Random& random) {
  constexpr std::array profiles{StringerProfile::l, StringerProfile::z, StringerProfile::hat};
  WingBay bay;
  bay.stringers.profile = one_of(profiles, random);
  bay.stringers.count = whole(3, 6, random);
  bay.stringers.height_mm = random.uniform(25.0, 45.0);
  bay.stringers.flange_mm = random.uniform(18.0, 28.0);
  bay.ribs.holes = whole(1, 4, random);
  bay.upper_skin = random.uniform() < 0.5;
  bay.skin_material = one_of(coats, random);
  bay.stringer_material = one_of(coats, random);
  bay.rib_material = one_of(coats, random);
  bay.spar_material = one_of(coats, random);
  return bay;
}

}  // namespace

Scene random_wing(std::uint64_t seed) {
  Random random(mix(seed, 0x3176));
  const WingBay bay = random_bay(random);
  Scene scene;
  scene.name = "random-wing-" + std::to_string(seed);
  scene.objects = build_wing_bay(bay);
  scene.bay = inside_of(bay);
  constexpr std::array ambients{0.0, 0.02, 0.05};
  scene.lighting.ambient = one_of(ambients, random);
  scene.stand.position_m = {0.0, 0.10, 0.0};
  scene.stand.pan_deg = random.uniform(-15.0, 15.0);
  scene.stand.tilt_deg = random.uniform(-32.0, -14.0);
  return scene;
}

void drop_debris(Scene& scene, std::uint64_t seed) {
  RandomDebris debris;
  debris.seed = seed;
  debris.within = {scene.bay.min().head<2>(), scene.bay.max().head<2>()};
  debris.from_m = default_look_down_m(scene);
  debris.count = 4;
  debris.kinds = {"collar-0.27"};
  (void)place_at_random(debris, scene);
  debris.group = 1;
  debris.count = 6;
  debris.kinds.clear();
  for (const DebrisKind& kind : debris_catalogue()) debris.kinds.emplace_back(kind.name);
  (void)place_at_random(debris, scene);
}

}  // namespace rva
