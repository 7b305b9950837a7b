// Eight frames of sixteen pixels at a time, in 16-bit deviations.
//
// Built with -mavx2 and entered only where the processor has it; it therefore includes nothing whose inline
// functions the rest of the program might come to share.
#include "depth/depth_statistics_kernel.hpp"

#if defined(__AVX2__)
#include <immintrin.h>

namespace rva::kernel {
namespace {

constexpr std::size_t lane = 16;  // pixels in a register

// Eight squares of deviations up to this fit 32 bits: 8 * 23170^2 < 2^32.
constexpr std::uint16_t max_deviation = 23170;

__m256i load(const void* from) { return _mm256_loadu_si256(static_cast<const __m256i*>(from)); }
void store(void* to, __m256i value) { _mm256_storeu_si256(static_cast<__m256i*>(to), value); }

// Where the reference has no depth yet, the first of these frames that has one gives it.
__m256i first_valid(__m256i reference, const std::uint16_t* const* frames, std::size_t count, std::size_t i) {
  const __m256i zero = _mm256_setzero_si256();
  for (std::size_t frame = 0; frame < count; ++frame) {
    const __m256i missing = _mm256_cmpeq_epi16(reference, zero);
    if (_mm256_testz_si256(missing, missing)) break;
    reference = _mm256_or_si256(reference, _mm256_and_si256(missing, load(frames[frame] + i)));
  }
  return reference;
}

// What one pass adds to sixteen pixels. "Low" and "high" are the halves that unpacking two registers of
// 16-bit numbers gives: pixels 0-3 and 8-11, pixels 4-7 and 12-15.
struct Added {
  __m256i count = _mm256_setzero_si256();          // 16 bits
  __m256i deviation_low = _mm256_setzero_si256();  // 32 bits
  __m256i deviation_high = _mm256_setzero_si256();
  __m256i square_low = _mm256_setzero_si256();  // 32 bits, unsigned
  __m256i square_high = _mm256_setzero_si256();
  __m256i largest = _mm256_setzero_si256();  // magnitude, 16 bits, unsigned

  // Deviation from the reference, 0 where there is no depth. Depths are compared with their top bit turned,
  // as signed numbers, so that a difference beyond 16 bits saturates and is seen in `largest`.
  __m256i deviation(const std::uint16_t* depths, __m256i turned_reference) {
    const __m256i depth = load(depths);
    const __m256i invalid = _mm256_cmpeq_epi16(depth, _mm256_setzero_si256());
    const __m256i turned = _mm256_xor_si256(depth, _mm256_set1_epi16(INT16_MIN));
    const __m256i difference = _mm256_andnot_si256(invalid, _mm256_subs_epi16(turned, turned_reference));
    count = _mm256_sub_epi16(count, _mm256_andnot_si256(invalid, _mm256_set1_epi16(-1)));
    largest = _mm256_max_epu16(largest, _mm256_abs_epi16(difference));
    return difference;
  }

  // Two frames at once: the multiply-and-add of pairs sums a pixel's two deviations, or their squares.
  void add(__m256i first, __m256i second) {
    const __m256i ones = _mm256_set1_epi16(1);
    const __m256i low = _mm256_unpacklo_epi16(first, second);
    const __m256i high = _mm256_unpackhi_epi16(first, second);
    deviation_low = _mm256_add_epi32(deviation_low, _mm256_madd_epi16(low, ones));
    deviation_high = _mm256_add_epi32(deviation_high, _mm256_madd_epi16(high, ones));
    square_low = _mm256_add_epi32(square_low, _mm256_madd_epi16(low, low));
    square_high = _mm256_add_epi32(square_high, _mm256_madd_epi16(high, high));
  }

  [[nodiscard]] bool fits() const {
    const __m256i limit = _mm256_set1_epi16(static_cast<short>(max_deviation));
    const __m256i within = _mm256_cmpeq_epi16(_mm256_max_epu16(largest, limit), limit);
    return _mm256_movemask_epi8(within) == -1;
  }
};

void add_squares(std::uint64_t* to, __m128i squares) {
  store(to, _mm256_add_epi64(load(to), _mm256_cvtepu32_epi64(squares)));
}

void add_to_sums(const Added& added, const Sums& sums, std::size_t i) {
  store(sums.count + i, _mm256_add_epi16(load(sums.count + i), added.count));
  // Back from the unpacked halves to the order of the pixels.
  const __m256i deviation_0 = _mm256_permute2x128_si256(added.deviation_low, added.deviation_high, 0x20);
  const __m256i deviation_8 = _mm256_permute2x128_si256(added.deviation_low, added.deviation_high, 0x31);
  store(sums.sum + i, _mm256_add_epi32(load(sums.sum + i), deviation_0));
  store(sums.sum + i + 8, _mm256_add_epi32(load(sums.sum + i + 8), deviation_8));
  add_squares(sums.sum_of_squares + i, _mm256_castsi256_si128(added.square_low));
  add_squares(sums.sum_of_squares + i + 4, _mm256_castsi256_si128(added.square_high));
  add_squares(sums.sum_of_squares + i + 8, _mm256_extracti128_si256(added.square_low, 1));
  add_squares(sums.sum_of_squares + i + 12, _mm256_extracti128_si256(added.square_high, 1));
}

void add_portable_from(const std::uint16_t* const* frames, std::size_t count, std::size_t i,
                       std::size_t pixels, const Sums& sums) {
  const std::uint16_t* runs[frames_per_pass];
  for (std::size_t frame = 0; frame < count; ++frame) runs[frame] = frames[frame] + i;
  add_pass_portable(runs, count, pixels,
                    {sums.reference + i, sums.count + i, sums.sum + i, sums.sum_of_squares + i});
}

}  // namespace

bool has_avx2() { return __builtin_cpu_supports("avx2"); }

void add_pass_avx2(const std::uint16_t* const* frames, std::size_t count, std::size_t pixels,
                   const Sums& sums) {
  std::size_t i = 0;
  for (; i + lane <= pixels; i += lane) {
    const __m256i reference = first_valid(load(sums.reference + i), frames, count, i);
    const __m256i turned_reference = _mm256_xor_si256(reference, _mm256_set1_epi16(INT16_MIN));
    Added added;
    std::size_t frame = 0;
    for (; frame + 2 <= count; frame += 2) {
      const __m256i first = added.deviation(frames[frame] + i, turned_reference);
      added.add(first, added.deviation(frames[frame + 1] + i, turned_reference));
    }
    if (frame < count)
      added.add(added.deviation(frames[frame] + i, turned_reference), _mm256_setzero_si256());
    if (added.fits()) {
      store(sums.reference + i, reference);
      add_to_sums(added, sums, i);
    } else {
      add_portable_from(frames, count, i, lane, sums);
    }
  }
  if (i < pixels) add_portable_from(frames, count, i, pixels - i, sums);
}

}  // namespace rva::kernel

#else

namespace rva::kernel {

bool has_avx2() { return false; }

void add_pass_avx2(const std::uint16_t* const* frames, std::size_t count, std::size_t pixels,
                   const Sums& sums) {
  add_pass_portable(frames, count, pixels, sums);
}

}  // namespace rva::kernel

#endif
