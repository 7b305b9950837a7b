// The result of a pixel by pixel comparison, for every pixel of the final depth image.
#pragma once

#include <cstddef>
#include <optional>

#include "depth/image.hpp"

namespace rva {

/// Shares of the final depth image; they sum to 1.
struct Coverage {
  double compared = 0.0;  ///< measured before and after
  double unseen = 0.0;    ///< measured after only; no initial capture measured it
  double invalid = 0.0;   ///< not measured after
  /// Measured after, but outside the distance or box to which the method is limited; empty for methods
  /// without such a limit.
  std::optional<double> beyond_clip{};
  /// Left out by the user, whether measured or not; empty if nothing was left out.
  std::optional<double> left_out{};
};

/// True if pixel i is left out by the user.
/// @param left_out set at the pixels to leave out; empty for none
[[nodiscard]] inline bool is_left_out(const Mask& left_out, std::size_t i) {
  return !left_out.empty() && left_out[i] != 0;
}

/// A pixel in which a change of this size would go undetected counts as not inspected. The value is the
/// thesis' constant threshold, with which neither a key nor a collar is found.
inline constexpr double blind_from_m = 0.05;

/// A pixel by pixel comparison of two captures of one view. All images have the size of the depth image.
struct Comparison {
  /// Initially no pixel is measured or changed.
  Comparison(int width, int height)
      : changed(width, height),
        farther(width, height),
        initial_m(width, height),
        final_m(width, height),
        evidence(width, height) {}

  Mask changed;            ///< set where the method found a change
  Mask farther;            ///< set at changed pixels that are farther than before, or whose depth appeared
  Image<float> initial_m;  ///< depth before, metres; 0 where not measured
  Image<float> final_m;    ///< depth after, metres; 0 where not measured
  Image<float> evidence;   ///< by how much the pixel exceeds noise, in the method's unit; 0 where not changed
  /// True if `evidence` is -log10 of the expected number of locations in an unchanged inspection that show as
  /// much of it.
  bool evidence_is_rarity = false;
  Coverage coverage;
  /// Share of the compared pixels in which a change of blind_from_m would not have been found, or which could
  /// not be judged; 0 if the method does not estimate it.
  double blind = 0.0;
};

}  // namespace rva
