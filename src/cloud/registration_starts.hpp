// Where a camera may have been put back.
#pragma once

#include <vector>

#include "geometry/transform.hpp"

namespace rva {

/// Poses around a guess, so dense that one of them is within the reach of a coarse registration of any camera
/// that was moved by up to 0.5 m and turned by up to 20 degrees about what is vertical to the robot, tilted
/// down by 0 to 40 degrees: turns, and shifts to the side and along the view.
[[nodiscard]] std::vector<Transform> starts_around(const Transform& initial_from_final);

}  // namespace rva
