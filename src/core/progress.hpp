// How far long work has come.
#pragma once

#include <cstddef>
#include <functional>
#include <string_view>

namespace rva {

/// Called on the thread that asked for the work, after each piece: `step` says what is being done,
/// `done` of `total` pieces are. An empty function is allowed and reports nothing.
using Progress = std::function<void(std::string_view step, std::size_t done, std::size_t total)>;

}  // namespace rva
