// Debris at random positions, the same for the same seed on every machine.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "scene/scene.hpp"

namespace rva {

/// Debris to be drawn by chance.
struct RandomDebris {
  int count = 1;                   ///< number of objects
  std::vector<std::string> kinds;  ///< names in debris_catalogue(), equally likely
  std::uint64_t seed = 1;          ///< determines kinds, shapes and positions
  std::uint64_t group = 0;         ///< distinguishes sets of one seed
  Eigen::AlignedBox2d within;      ///< where centres of mass may lie, world x and y
  double from_m = 0;               ///< world z from which they fall
};

/// Adds objects without names that rest on the scene, inside the bay and clear of all other debris.
/// @return the number of objects added, at most `count`
[[nodiscard]] int place_at_random(const RandomDebris& wanted, Scene& scene);

}  // namespace rva
