// The effect of dust, smears and fingerprints on the light of a surface.
#pragma once

#include <Eigen/Core>
#include <span>

#include "scene/trace.hpp"

namespace rva {

/// The factor by which traces change the light that a surface reflects; 1 where there is no trace.
/// @param position world, metres
[[nodiscard]] float trace_light(std::span<const Trace> traces, const Eigen::Vector3f& position);

}  // namespace rva
