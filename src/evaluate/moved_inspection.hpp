// A simulated inspection by the path that real captures take: a robot moves to a view before and after the
// work, and the sides are compared as `rva detect` and the console compare them.
#pragma once

#include <cstdint>

#include "evaluate/moved_study.hpp"

namespace rva {

/// One inspection as `rva serve` performs it: captures by a robot (robot_side.hpp), compared by detect(),
/// which gets no information that `rva serve` and `rva detect` lack.
/// @throws Error if captures cannot be written; Interrupted
[[nodiscard]] MovedInspection inspect_moved(const MovedStudyOptions& options, std::uint64_t seed);

}  // namespace rva
