// The path that a mechanic's captures take: a robot that goes to a view before and after the work, and the
// comparison that `rva detect` and the console make.
#pragma once

#include <cstdint>

#include "evaluate/moved_study.hpp"

namespace rva {

/// One inspection as `rva serve` makes it: captures by a robot (robot_side.hpp), compared by detect(), with
/// nothing that `rva serve` or `rva detect` does not know.
/// @throws Error when captures cannot be written; Interrupted
[[nodiscard]] MovedInspection inspect_moved(const MovedStudyOptions& options, std::uint64_t seed);

}  // namespace rva
