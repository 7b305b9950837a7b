// Progress as a line that is updated in place.
#pragma once

#include "core/progress.hpp"

namespace rva::cli {

/// Writes `step done/total` to stderr while work goes on and wipes it at the end; nothing where stderr is not
/// a terminal.
[[nodiscard]] Progress terminal_progress();

}  // namespace rva::cli
