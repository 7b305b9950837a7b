// The path that a mechanic's captures take: a robot that returns, and the comparison that the console makes.
#pragma once

#include <cstdint>

#include "evaluate/moved_study.hpp"

namespace rva {

/// One inspection as `rva serve` makes it: captures by a robot that rests within half a step of what it
/// reports (robot_side.hpp), compared by detect(), with nothing that `rva serve` or `rva detect` does not
/// know.
/// @throws Error when captures cannot be written; Interrupted
[[nodiscard]] MovedInspection inspect_by_robot(const MovedStudyOptions& options, std::uint64_t seed);

}  // namespace rva
