// What dust, smears and fingerprints leave of a surface's light.
#pragma once

#include <Eigen/Core>
#include <span>

#include "sim/scene/trace.hpp"

namespace rva {

/// Factor of the light that a surface sends back, 1 where there is no trace.
/// @param position world, metres
[[nodiscard]] float trace_light(std::span<const Trace> traces, const Eigen::Vector3f& position);

}  // namespace rva
