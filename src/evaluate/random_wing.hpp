// Random wings, so that trials are not tuned to known scenes.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene.hpp"
#include "scene/wing/wing_bay.hpp"

namespace rva {

/// Features of real bays that make detection harder. A plain bay has none of them.
struct BayFeatures {
  bool brackets = false;  ///< angles of sheet metal
  bool hoses = false;     ///< hoses from rib to rib
  bool cables = false;    ///< cables across the stringers
  bool sealant = false;   ///< beads of sealant
  bool dirt = false;      ///< dust and old oil on all surfaces
  bool skins = false;     ///< coats of carbon fibre, yellow primer and wax as well
  bool work = false;      ///< planned changes by a mechanic between the two sides
  bool traces = false;    ///< dust, smears and fingerprints left by the work

  bool operator==(const BayFeatures&) const = default;
};

/// "brackets" ... "traces", in the order of the members.
[[nodiscard]] std::vector<std::string_view> bay_feature_names();

/// The features of these names.
/// @param names names from bay_feature_names(), or "all"
/// @throws UsageError for any other name
[[nodiscard]] BayFeatures bay_features(const std::vector<std::string>& names);

/// The bay that random_wing() builds.
[[nodiscard]] WingBay random_wing_bay(std::uint64_t seed, const BayFeatures& features = {});

/// Random planned changes to a bay: installed collars, brackets or sealant, and cables that hang differently.
[[nodiscard]] Work random_work(std::uint64_t seed);

/// One or two patches of dust, one or two smears, and one to three fingerprints.
[[nodiscard]] TraceCounts random_traces(std::uint64_t seed);

/// A bay with random stringers, ribs, materials, light and camera view: 3 to 6 L, Z or hat stringers, 25 to
/// 45 mm high; paint, primer or aluminium; with or without an upper skin; the camera in the access hole,
/// panned by up to 15 degrees and tilted down by 14 to 32 degrees. It contains no debris. The same seed gives
/// the same sheet metal, light and view regardless of the features.
[[nodiscard]] Scene random_wing(std::uint64_t seed, const BayFeatures& features = {});

/// Drops four collars of 0.27 in and six pieces of random kinds of the catalogue at random positions in a
/// bay; fewer if no free position is found.
void drop_debris(Scene& scene, std::uint64_t seed);

}  // namespace rva
