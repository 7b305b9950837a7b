// Which way debris points where it lies.
#pragma once

#include <span>

#include "sim/scene/resting.hpp"

namespace rva {

/// Direction of the body's long axis on the floor, towards its lighter end (a screwdriver's tip): degrees
/// counterclockwise from x, when it is put down with a turn of 0.
[[nodiscard]] double lying_direction_deg(std::span<const Part> parts, const RestingOrientation& orientation);

}  // namespace rva
