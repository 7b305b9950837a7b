// Debris scattered by chance, the same for the same seed on every machine.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "sim/scene/scene.hpp"

namespace rva {

struct RandomDebris {
  int count = 1;
  std::vector<std::string> kinds;  ///< of debris_catalogue(); each as likely as another
  std::uint64_t seed = 1;
  std::uint64_t group = 0;     ///< sets of one seed differ by this
  Eigen::AlignedBox2d within;  ///< where centres of mass may lie, world x and y
  double from_m = 0;           ///< height from which they fall
};

/// Adds objects without names that rest on the scene, inside the bay and clear of all other debris.
/// @return how many found a place
[[nodiscard]] int place_at_random(const RandomDebris& wanted, Scene& scene);

}  // namespace rva
