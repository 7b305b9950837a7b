// The speed at which memory can be read at all: the bound on every statistic.
#pragma once

#include <cstdint>
#include <span>

namespace rva::bench {

/// Reads every pixel and does the least that keeps the compiler from leaving it out.
[[nodiscard]] std::uint64_t read_only(std::span<const std::uint16_t> pixels);

}  // namespace rva::bench
