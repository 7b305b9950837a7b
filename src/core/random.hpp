// Randomness from seeds: the same seed gives the same bits and uniform numbers with every compiler and
// library, which the standard's distributions do not guarantee. Normal numbers may differ in the last digit
// where the library's logarithm or cosine does.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

namespace rva {

/// Hashes several numbers to one (the finaliser of splitmix64, Steele et al., OOPSLA 2014).
template <typename... Numbers>
[[nodiscard]] constexpr std::uint64_t mix(Numbers... numbers) {
  std::uint64_t state = 0;
  const auto stir = [&state](std::uint64_t number) {
    state += number + 0x9E3779B97F4A7C15ULL;
    state = (state ^ (state >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    state = (state ^ (state >> 27U)) * 0x94D049BB133111EBULL;
    state ^= state >> 31U;
  };
  (stir(static_cast<std::uint64_t>(numbers)), ...);
  return state;
}

/// A stream of random numbers (splitmix64). It is small and quick to seed, so that each row of each frame can
/// have a stream of its own.
class Random {
 public:
  /// Equal seeds give equal streams.
  explicit constexpr Random(std::uint64_t seed) : state_(seed) {}

  /// 64 random bits.
  [[nodiscard]] constexpr std::uint64_t bits() {
    state_ += 0x9E3779B97F4A7C15ULL;
    std::uint64_t z = state_;
    z = (z ^ (z >> 30U)) * 0xBF58476D1CE4E5B9ULL;
    z = (z ^ (z >> 27U)) * 0x94D049BB133111EBULL;
    return z ^ (z >> 31U);
  }
  /// In [0, 1).
  [[nodiscard]] constexpr double uniform() { return static_cast<double>(bits() >> 11U) * 0x1.0p-53; }
  /// In [low, high).
  [[nodiscard]] constexpr double uniform(double low, double high) { return low + (high - low) * uniform(); }
  /// Mean 0, standard deviation 1 (Box and Muller 1958).
  [[nodiscard]] double normal() {
    const double radius = std::sqrt(-2.0 * std::log(1.0 - uniform()));
    return radius * std::cos(2.0 * std::numbers::pi * uniform());
  }

 private:
  std::uint64_t state_;
};

}  // namespace rva
