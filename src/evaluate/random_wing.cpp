#include "evaluate/random_wing.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <string>
#include <string_view>

#include "core/error.hpp"
#include "core/options.hpp"
#include "core/path_text.hpp"
#include "core/random.hpp"
#include "scene/debris/debris_catalogue.hpp"
#include "scene/debris/random_debris.hpp"
#include "scene/drop_zone.hpp"

namespace rva {
namespace {

// Half of the coats are green primer, as in real wings.
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

// Replaces each coat, with a probability of one half, by one that plain bays do not have.
void paint_otherwise(Random& random, WingBay& bay) {
  constexpr std::array<std::string_view, 3> others{"carbon-fibre", "yellow-primer", "wax-coating"};
  for (std::string* const material :
       {&bay.skin_material, &bay.stringer_material, &bay.rib_material, &bay.spar_material}) {
    if (random.uniform() < 0.5) *material = one_of(others, random);
  }
}

void furnish(const BayFeatures& features, std::uint64_t seed, WingBay& bay) {
  Random random(mix(seed, 0xF177));
  bay.fittings.seed = mix(seed, 0xF178);
  // All are drawn regardless of the features, so that one feature does not change another.
  const int brackets = whole(2, 6, random);
  const int hoses = whole(1, 2, random);
  const int cables = whole(1, 3, random);
  const int sealant = whole(2, 5, random);
  const double dirt = random.uniform(0.2, 0.7);
  if (features.brackets) bay.fittings.brackets = brackets;
  if (features.hoses) bay.fittings.hoses = hoses;
  if (features.cables) bay.fittings.cables = cables;
  if (features.sealant) bay.fittings.sealant = sealant;
  if (features.dirt) bay.dirt = dirt;
  if (features.skins) paint_otherwise(random, bay);
}

struct Feature {
  std::string_view name;
  bool BayFeatures::*member;
};

constexpr std::array bay_feature_table{
    Feature{"brackets", &BayFeatures::brackets}, Feature{"hoses", &BayFeatures::hoses},
    Feature{"cables", &BayFeatures::cables},     Feature{"sealant", &BayFeatures::sealant},
    Feature{"dirt", &BayFeatures::dirt},         Feature{"skins", &BayFeatures::skins},
    Feature{"work", &BayFeatures::work},         Feature{"traces", &BayFeatures::traces}};

}  // namespace

std::vector<std::string_view> bay_feature_names() {
  std::vector<std::string_view> names;
  for (const Feature& feature : bay_feature_table) names.push_back(feature.name);
  return names;
}

BayFeatures bay_features(const std::vector<std::string>& names) {
  BayFeatures features;
  for (const std::string& name : names) {
    bool known = false;
    for (const Feature& feature : bay_feature_table) {
      if (name != feature.name && name != "all") continue;
      features.*feature.member = known = true;
    }
    if (!known)
      throw OptionError("bay", printable(name) + " is not a known bay feature",
                        fmt::format("give some of {}, or all", fmt::join(bay_feature_names(), ", ")));
  }
  return features;
}

WingBay random_wing_bay(std::uint64_t seed, const BayFeatures& features) {
  Random random(mix(seed, 0x3176));
  WingBay bay = random_bay(random);
  furnish(features, seed, bay);
  return bay;
}

Work random_work(std::uint64_t seed) {
  Random random(mix(seed, 0x3012));
  Work work;
  work.installed.seed = mix(seed, 0x3013);
  work.installed.collars = whole(1, 2, random);
  work.installed.brackets = whole(0, 1, random);
  work.installed.sealant = whole(0, 2, random);
  work.rehung = whole(0, 1, random);
  return work;
}

TraceCounts random_traces(std::uint64_t seed) {
  Random random(mix(seed, 0x77AC));
  TraceCounts counts;
  counts.dust = whole(1, 2, random);
  counts.smears = whole(1, 2, random);
  counts.fingerprints = whole(1, 3, random);
  counts.seed = mix(seed, 0x77AD);
  return counts;
}

Scene random_wing(std::uint64_t seed, const BayFeatures& features) {
  Random random(mix(seed, 0x3176));
  (void)random_bay(random);  // advances the random stream past the bay
  const WingBay bay = random_wing_bay(seed, features);
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
