// What a static method says about every pixel of the final depth image.
#pragma once

#include <cstddef>
#include <optional>

#include "depth/image.hpp"

namespace rva {

/// Shares of the final depth image; they sum to 1.
struct Coverage {
  double compared = 0.0;                ///< measured before and after
  double unseen = 0.0;                  ///< measured after only: the initial capture never saw it
  double invalid = 0.0;                 ///< not measured after
  std::optional<double> beyond_clip{};  ///< measured, but left out as too far, where a method clips
  std::optional<double> left_out{};  ///< by a person's wish, whatever was measured there; empty without one
};

/// The pixels that a person wants left out, or an empty mask for none: true where pixel i is one of them.
[[nodiscard]] inline bool is_left_out(const Mask& left_out, std::size_t i) {
  return !left_out.empty() && left_out[i] != 0;
}

/// A place where a change of so much would go unseen was as good as not inspected: it is the thesis' constant
/// threshold, which finds no key and no collar.
inline constexpr double blind_from_m = 0.05;

/// A pixel for pixel comparison of two captures from one place. All images have the size of the depth image.
struct Comparison {
  /// Nothing measured, nothing changed.
  Comparison(int width, int height)
      : changed(width, height),
        farther(width, height),
        initial_m(width, height),
        final_m(width, height),
        evidence(width, height) {}

  Mask changed;            ///< set where the method found a change
  Mask farther;            ///< set at those changed pixels that went farther, or whose depth appeared
  Image<float> initial_m;  ///< depth before, metres; 0 where not measured
  Image<float> final_m;    ///< depth after, metres; 0 where not measured
  Image<float> evidence;   ///< how far the pixel exceeds noise, in the method's own unit; 0 where not changed
  /// Evidence is -log10 of the number of places with as much of it that an unchanged inspection would show.
  bool evidence_is_rarity = false;
  Coverage coverage;
  /// Share of the compared pixels in which a change of blind_from_m would not have been found, or which could
  /// not be judged; 0 where the method does not know.
  double blind = 0.0;
};

}  // namespace rva
