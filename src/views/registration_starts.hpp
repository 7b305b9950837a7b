// Start poses for the registration of a camera that was put back.
#pragma once

#include <vector>

#include "geometry/transform.hpp"

namespace rva {

/// Poses around a guess, spaced so that a coarse registration converges from one of them for any camera that
/// was moved by up to 0.5 m and turned by up to 20 degrees about the vertical axis of the robot, tilted down
/// by 0 to 40 degrees: turns, and shifts sideways and along the view.
[[nodiscard]] std::vector<Transform> starts_around(const Transform& initial_from_final);

}  // namespace rva
