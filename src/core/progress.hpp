// Progress reports of long work.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

namespace rva {

/// Called after each piece of work, on the thread that asked for the work: `step` names what is being done,
/// and `done` of `total` pieces are complete. An empty function is allowed and reports nothing.
using Progress = std::function<void(std::string_view step, std::size_t done, std::size_t total)>;

}  // namespace rva
