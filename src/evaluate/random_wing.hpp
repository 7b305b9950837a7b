// Wings that nobody built by hand, for trials that no one could have prepared for.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "sim/scene/scene.hpp"
#include "sim/scene/wing_bay.hpp"

namespace rva {

/// What makes a bay harder, as real ones are. None of it is in a plain bay.
struct BayFeatures {
  bool brackets = false;
  bool hoses = false;
  bool cables = false;
  bool sealant = false;
  bool dirt = false;
  bool skins = false;   ///< carbon fibre, yellow primer and wax, too
  bool work = false;    ///< a mechanic's legitimate changes between the two sides
  bool traces = false;  ///< dust, smears and fingerprints that the work left

  bool operator==(const BayFeatures&) const = default;
};

/// "brackets" ... "traces", in the order of the members.
[[nodiscard]] std::vector<std::string_view> bay_feature_names();

/// @param names of bay_feature_names(), or "all"
/// @throws UsageError for any other
[[nodiscard]] BayFeatures bay_features(const std::vector<std::string>& names);

/// The bay that random_wing() builds.
[[nodiscard]] WingBay random_wing_bay(std::uint64_t seed, const BayFeatures& features = {});

/// A mechanic's changes of a bay, drawn by chance: collars, brackets or sealant that were installed, cables
/// that hang differently.
[[nodiscard]] Work random_work(std::uint64_t seed);

/// One or two patches of dust and smears each, and one to three fingerprints.
[[nodiscard]] TraceCounts random_traces(std::uint64_t seed);

/// A bay with its stringers, ribs, materials, light and the camera's view drawn by chance: L, Z or hat
/// stringers, 3 to 6 of them, 25 to 45 mm high; paint, primer or aluminium; with or without an upper skin;
/// the camera in the access hole, panned by up to 15 and tilted down by 14 to 32 degrees. Nothing lies in it.
/// The same seed gives the same sheet metal, light and view whatever the features.
[[nodiscard]] Scene random_wing(std::uint64_t seed, const BayFeatures& features = {});

/// Drops four collars of 0.27 in and six other pieces of the catalogue into a bay, by chance; fewer where no
/// place is found.
void drop_debris(Scene& scene, std::uint64_t seed);

}  // namespace rva
