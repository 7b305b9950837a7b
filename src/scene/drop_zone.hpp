// Where debris may lie, and the height from which it falls.
#pragma once

#include "scene/scene.hpp"

namespace rva {

/// The z from which debris falls by default: half the bay's height, so that it lands on skin and stringers
/// rather than on the caps along the upper skin. Without a wing, half a metre above all objects.
[[nodiscard]] double default_look_down_m(const Scene& scene);

/// True if no part of the object extends beyond the bay, or if there is no wing.
[[nodiscard]] bool lies_inside(const Scene& scene, const SceneObject& object);

}  // namespace rva
