// Dust, smears and fingerprints that work leaves in a bay.
#pragma once

#include "sim/scene/scene.hpp"

namespace rva {

/// Leaves traces by chance on what lies open from above, within the bay; fewer where nothing does. Each makes
/// surfaces 3 to 15 % darker, or, dust only, brighter.
void leave_traces(const TraceCounts& counts, Scene& scene);

}  // namespace rva
