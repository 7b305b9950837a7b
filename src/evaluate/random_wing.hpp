// Wings that nobody built by hand, for trials that no one could have prepared for.
#pragma once

#include <cstdint>

#include "sim/scene/scene.hpp"

namespace rva {

/// A bay with its stringers, ribs, materials, light and the camera's view drawn by chance: L, Z or hat
/// stringers, 3 to 6 of them, 25 to 45 mm high; paint, primer or aluminium; with or without an upper skin;
/// the camera in the access hole, panned by up to 15 and tilted down by 14 to 32 degrees. Nothing lies in it.
[[nodiscard]] Scene random_wing(std::uint64_t seed);

/// Drops four collars of 0.27 in and six other pieces of the catalogue into a bay, by chance; fewer where no
/// place is found.
void drop_debris(Scene& scene, std::uint64_t seed);

}  // namespace rva
