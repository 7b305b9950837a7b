// Pixels at which the stereo matcher is unreliable.
#pragma once

#include <cstdint>

#include "views/disparity_change.hpp"

namespace rva {

/// A quantity that differs between pixels where the matcher is reliable (`reliable`) and unreliable
/// (`unreliable`).
template <typename Of>
struct ByReliability {
  Of reliable;
  Of unreliable;

  [[nodiscard]] const Of& at(std::uint8_t is_unreliable) const {
    return is_unreliable != 0 ? unreliable : reliable;
  }
};

/// Returns a mask that is set where the matcher is unreliable: where the mean variance of disparity over time
/// in a window of 9 x 9 pixels exceeds the variance that four fifths of the pixels stay below, or where in
/// both captures more than 7 pixels of a window of 17 x 17 have no depth. Beside holes, steps and
/// highlights, a match that stays the same throughout one capture may be another in the next, so a change of
/// the same size is less likely to be a real one. Holes that debris causes are in one capture only, and do
/// not make a pixel unreliable.
[[nodiscard]] Mask unreliable_pixels(const DisparityChange& change);

}  // namespace rva
