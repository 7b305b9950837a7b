// The speed at which memory can be read, which bounds that of any statistic.
#pragma once

#include <cstdint>
#include <span>

namespace rva::bench {

/// Reads every pixel, with the least work that prevents the compiler from removing the loop.
[[nodiscard]] std::uint64_t read_only(std::span<const std::uint16_t> pixels);

}  // namespace rva::bench
