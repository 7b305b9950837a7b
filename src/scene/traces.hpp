// Dust, smears and fingerprints that work leaves in a bay.
#pragma once

#include "scene/scene.hpp"

namespace rva {

/// Adds traces at random to surfaces within the bay that are exposed from above; fewer than asked for if a
/// random position has no such surface. Each makes surfaces 3 to 15 % darker, or, for dust only, brighter.
void leave_traces(const TraceCounts& counts, Scene& scene);

}  // namespace rva
