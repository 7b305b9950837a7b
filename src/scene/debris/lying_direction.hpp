// The direction in which debris points on the floor.
#pragma once

#include <span>

#include "scene/debris/resting.hpp"

namespace rva {

/// Direction of the body's long axis on the floor, towards its lighter end (the tip of a screwdriver), if it
/// is put down with a turn of 0: degrees, counterclockwise from x.
[[nodiscard]] double lying_direction_deg(std::span<const Part> parts, const RestingOrientation& orientation);

}  // namespace rva
