#include "bench/read_only.hpp"

#if defined(__AVX2__)
#include <immintrin.h>

namespace rva::bench {

std::uint64_t read_only(std::span<const std::uint16_t> pixels) {
  constexpr std::size_t step = 64;  // pixels in four registers
  __m256i sums[4] = {};
  std::size_t i = 0;
  for (; i + step <= pixels.size(); i += step) {
    const auto* from = reinterpret_cast<const __m256i*>(pixels.data() + i);
    for (int k = 0; k < 4; ++k) sums[k] = _mm256_add_epi64(sums[k], _mm256_loadu_si256(from + k));
  }
  const __m256i sum =
      _mm256_add_epi64(_mm256_add_epi64(sums[0], sums[1]), _mm256_add_epi64(sums[2], sums[3]));
  alignas(32) std::uint64_t lanes[4];
  _mm256_store_si256(reinterpret_cast<__m256i*>(lanes), sum);
  std::uint64_t total = lanes[0] + lanes[1] + lanes[2] + lanes[3];
  for (; i < pixels.size(); ++i) total += pixels[i];
  return total;
}

}  // namespace rva::bench

#else

namespace rva::bench {

std::uint64_t read_only(std::span<const std::uint16_t> pixels) {
  std::uint64_t total = 0;
  for (const std::uint16_t pixel : pixels) total += pixel;
  return total;
}

}  // namespace rva::bench

#endif
