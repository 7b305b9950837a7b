// What a bay holds besides its sheet metal: brackets, hoses, cables, sealant, rows of collars.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "sim/scene/scene.hpp"

namespace rva {

struct WingBay;

/// How many of each. Shapes and places follow from the seed.
struct Fittings {
  int brackets = 0;  ///< angles of sheet metal, riveted to the lower skin between stringers
  int hoses = 0;     ///< from rib to rib above the stringers, in clamps
  int cables = 0;    ///< across the stringers, resting on each and sagging in between
  int sealant = 0;   ///< beads along a stringer's foot
  int collars = 0;   ///< rows of six swaged collars, upright on the lower skin
  std::uint64_t seed = 1;

  bool operator==(const Fittings&) const = default;
};

/// Made by chance within the bay: "bracket-1", "hose-1", "cable-1", "sealant-1", "collars-1" ...
/// @param role       structure before the work, `work` where a mechanic installed it
/// @param name_prefix before each name
[[nodiscard]] std::vector<SceneObject> make_fittings(const WingBay& bay, const Fittings& fittings, Role role,
                                                     std::string_view name_prefix = "");

/// What a mechanic legitimately changes.
struct Work {
  Fittings installed;
  int rehung = 0;  ///< cables of the bay that hang differently afterwards
  TraceCounts traces{};
};

/// Adds what was installed, and puts cables that hang differently in place of those of the bay; all of it has
/// Role::work. Leaves traces on it and on the bay.
void do_work(const WingBay& bay, const Work& work, Scene& scene);

}  // namespace rva
