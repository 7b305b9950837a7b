// The contents of a bay besides its sheet metal: brackets, hoses, cables, sealant, rows of collars.
#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"

namespace rva {

struct WingBay;

/// The number of fittings of each kind. Their shapes and positions follow from the seed.
struct Fittings {
  int brackets = 0;        ///< angles of sheet metal, riveted to the lower skin between stringers
  int hoses = 0;           ///< from rib to rib above the stringers, in clamps
  int cables = 0;          ///< across the stringers, resting on each and sagging in between
  int sealant = 0;         ///< beads along the foot of a stringer
  int collars = 0;         ///< rows of six swaged collars, upright on the lower skin
  std::uint64_t seed = 1;  ///< determines shapes and positions

  bool operator==(const Fittings&) const = default;
};

/// Random fittings within the bay, named "bracket-1", "hose-1", "cable-1", "sealant-1", "collars-1" ...
/// @param role        `structure` for fittings present before the work, `work` for those that it installed
/// @param name_prefix put before each name
[[nodiscard]] std::vector<SceneObject> make_fittings(const WingBay& bay, const Fittings& fittings, Role role,
                                                     std::string_view name_prefix = "");

/// Planned changes by a mechanic.
struct Work {
  Fittings installed;    ///< fittings that are added
  int rehung = 0;        ///< number of the bay's cables that hang differently afterwards
  TraceCounts traces{};  ///< traces that are left
};

/// Adds the fittings that were installed, and replaces cables of the bay with ones that hang differently; all
/// of them have Role::work. Then adds traces to the surfaces, including the new ones.
void do_work(const WingBay& bay, const Work& work, Scene& scene);

}  // namespace rva
