// The inner loops of DepthStatistics, for it alone.
#pragma once

#include <cstddef>
#include <cstdint>

namespace rva::kernel {

/// The most frames that are added in one pass over the sums.
inline constexpr std::size_t frames_per_pass = 8;

/// The sums of a run of pixels.
struct Sums {
  std::uint16_t* reference;       ///< first valid depth; 0 until there is one
  std::uint16_t* count;           ///< number of valid depths
  std::int32_t* sum;              ///< sum of deviations from the reference
  std::uint64_t* sum_of_squares;  ///< sum of squared deviations from the reference
};

/// Adds `count` (1 to frames_per_pass) runs of `pixels` depths to the sums.
using AddPass = void (*)(const std::uint16_t* const* frames, std::size_t count, std::size_t pixels,
                         const Sums& sums);

/// Runs on every processor.
void add_pass_portable(const std::uint16_t* const* frames, std::size_t count, std::size_t pixels,
                       const Sums& sums);

/// Runs on processors with AVX2 (has_avx2()).
void add_pass_avx2(const std::uint16_t* const* frames, std::size_t count, std::size_t pixels,
                   const Sums& sums);

/// Whether add_pass_avx2() was built with AVX2 and the processor has it.
[[nodiscard]] bool has_avx2();

}  // namespace rva::kernel
