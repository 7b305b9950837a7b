// Eight frames of sixteen pixels at a time, in 16-bit deviations.
//
// This file is built with -mavx2 and used only where the processor has AVX2. It therefore includes nothing
// whose inline functions the linker could merge with those of the rest of the program.
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
bool any(__m256i bits) { return _mm256_testz_si256(bits, bits) == 0; }

// Sixteen pixels of the frames of a pass, prepared for taking deviations from the reference. Slots is the
// number of frames, rounded up to an even number; a spare slot contains the reference itself.
template <std::size_t Slots>
struct Block {
  __m256i depths[Slots];
  __m256i reference;
  __m256i added_count;  // frames in which the pixel was valid
  __m256i least;
  __m256i largest;

  Block(const std::uint16_t* const* frames, std::size_t count, std::size_t i,
        const std::uint16_t* reference_from)
      : reference(load(reference_from)), added_count(_mm256_set1_epi16(static_cast<short>(count))) {
    for (std::size_t k = 0; k < Slots; ++k) depths[k] = load(frames[k < count ? k : 0] + i);
    find_range();
    const __m256i zero = _mm256_setzero_si256();
    const __m256i unmeasured = _mm256_cmpeq_epi16(_mm256_min_epu16(least, reference), zero);
    // This is the case for a fifth of all blocks of real recordings.
    if (any(unmeasured)) fill_holes(count);
    if (count < Slots) depths[Slots - 1] = reference;
  }

  void find_range() {
    least = largest = depths[0];
    for (std::size_t k = 1; k < Slots; ++k) {
      least = _mm256_min_epu16(least, depths[k]);
      largest = _mm256_max_epu16(largest, depths[k]);
    }
  }

  // Where the reference has no depth yet, it takes the first depth of these frames. Holes are then filled
  // with the reference's depth, so that they have no deviation, and the count is reduced by one each.
  void fill_holes(std::size_t count) {
    const __m256i zero = _mm256_setzero_si256();
    for (std::size_t k = 0; k < Slots; ++k) {
      const __m256i missing = _mm256_cmpeq_epi16(reference, zero);
      reference = _mm256_or_si256(reference, _mm256_and_si256(missing, depths[k]));
    }
    for (std::size_t k = 0; k < Slots; ++k) {
      const __m256i hole = _mm256_cmpeq_epi16(depths[k], zero);
      depths[k] = _mm256_or_si256(depths[k], _mm256_and_si256(hole, reference));
      if (k < count) added_count = _mm256_add_epi16(added_count, hole);
    }
    find_range();
  }

  [[nodiscard]] bool fits() const {
    const __m256i above = _mm256_subs_epu16(largest, reference);
    const __m256i below = _mm256_subs_epu16(reference, least);
    const __m256i limit = _mm256_set1_epi16(static_cast<short>(max_deviation));
    return !any(_mm256_subs_epu16(_mm256_max_epu16(above, below), limit));
  }
};

void add_squares(std::uint64_t* to, __m128i squares) {
  store(to, _mm256_add_epi64(load(to), _mm256_cvtepu32_epi64(squares)));
}

// Processes two frames at once: multiply-and-add of pairs sums a pixel's two deviations, or their squares.
// "Low" and "high" are the halves that unpacking gives: pixels 0-3 and 8-11, and pixels 4-7 and 12-15.
template <std::size_t Slots>
void add_to_sums(const Block<Slots>& block, const Sums& sums, std::size_t i) {
  const __m256i ones = _mm256_set1_epi16(1);
  __m256i deviation_low = _mm256_setzero_si256();
  __m256i deviation_high = _mm256_setzero_si256();
  __m256i square_low = _mm256_setzero_si256();
  __m256i square_high = _mm256_setzero_si256();
  for (std::size_t k = 0; k < Slots; k += 2) {
    const __m256i first = _mm256_sub_epi16(block.depths[k], block.reference);
    const __m256i second = _mm256_sub_epi16(block.depths[k + 1], block.reference);
    const __m256i low = _mm256_unpacklo_epi16(first, second);
    const __m256i high = _mm256_unpackhi_epi16(first, second);
    deviation_low = _mm256_add_epi32(deviation_low, _mm256_madd_epi16(low, ones));
    deviation_high = _mm256_add_epi32(deviation_high, _mm256_madd_epi16(high, ones));
    square_low = _mm256_add_epi32(square_low, _mm256_madd_epi16(low, low));
    square_high = _mm256_add_epi32(square_high, _mm256_madd_epi16(high, high));
  }
  store(sums.reference + i, block.reference);
  store(sums.count + i, _mm256_add_epi16(load(sums.count + i), block.added_count));
  const __m256i deviation_0 = _mm256_permute2x128_si256(deviation_low, deviation_high, 0x20);
  const __m256i deviation_8 = _mm256_permute2x128_si256(deviation_low, deviation_high, 0x31);
  store(sums.sum + i, _mm256_add_epi32(load(sums.sum + i), deviation_0));
  store(sums.sum + i + 8, _mm256_add_epi32(load(sums.sum + i + 8), deviation_8));
  add_squares(sums.sum_of_squares + i, _mm256_castsi256_si128(square_low));
  add_squares(sums.sum_of_squares + i + 4, _mm256_castsi256_si128(square_high));
  add_squares(sums.sum_of_squares + i + 8, _mm256_extracti128_si256(square_low, 1));
  add_squares(sums.sum_of_squares + i + 12, _mm256_extracti128_si256(square_high, 1));
}

void add_portable_from(const std::uint16_t* const* frames, std::size_t count, std::size_t i,
                       std::size_t pixels, const Sums& sums) {
  const std::uint16_t* runs[frames_per_pass];
  for (std::size_t frame = 0; frame < count; ++frame) runs[frame] = frames[frame] + i;
  add_pass_portable(runs, count, pixels,
                    {sums.reference + i, sums.count + i, sums.sum + i, sums.sum_of_squares + i});
}

template <std::size_t Slots>
void add_pass_of(const std::uint16_t* const* frames, std::size_t count, std::size_t pixels,
                 const Sums& sums) {
  std::size_t i = 0;
  for (; i + lane <= pixels; i += lane) {
    const Block<Slots> block(frames, count, i, sums.reference + i);
    if (block.fits()) {
      add_to_sums(block, sums, i);
    } else {
      add_portable_from(frames, count, i, lane, sums);
    }
  }
  if (i < pixels) add_portable_from(frames, count, i, pixels - i, sums);
}

}  // namespace

bool has_avx2() { return __builtin_cpu_supports("avx2"); }

void add_pass_avx2(const std::uint16_t* const* frames, std::size_t count, std::size_t pixels,
                   const Sums& sums) {
  switch (count) {
    case 1:
    case 2:
      return add_pass_of<2>(frames, count, pixels, sums);
    case 3:
    case 4:
      return add_pass_of<4>(frames, count, pixels, sums);
    case 5:
    case 6:
      return add_pass_of<6>(frames, count, pixels, sums);
    default:
      return add_pass_of<8>(frames, count, pixels, sums);
  }
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
