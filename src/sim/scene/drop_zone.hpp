// Where debris may lie, and from where it falls.
#pragma once

#include "sim/scene/scene.hpp"

namespace rva {

/// Height from which to look down for a place to lie: half the bay's height, so that debris finds skin and
/// stringers rather than the caps along the upper skin. Without a wing, just above all objects.
[[nodiscard]] double default_look_down_m(const Scene& scene);

/// True when nothing of the object sticks out of the bay, or when there is no wing.
[[nodiscard]] bool lies_inside(const Scene& scene, const SceneObject& object);

}  // namespace rva
