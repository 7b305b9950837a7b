// Two sets of depth images, pixel by pixel, in disparity: there the noise of a stereo camera is as even as it
// gets, and a millimetre counts for what the camera makes of it at that distance.
#pragma once

#include "depth/depth_statistics.hpp"
#include "depth/image.hpp"

namespace rva {

/// Nothing is judged so near to the image's border: a matcher lacks half of its window there.
inline constexpr int margin_px = 6;

[[nodiscard]] inline bool inside_margin(int u, int v, int width, int height, int margin = margin_px) {
  return u >= margin && v >= margin && u < width - margin && v < height - margin;
}

/// All images have the size of the statistics.
struct DisparityChange {
  DisparityChange(int width, int height)
      : before_px(width, height),
        after_px(width, height),
        deviation_px(width, height),
        judged(width, height),
        lost(width, height) {}

  std::size_t frames = 1;     ///< of the set that has fewer
  Image<float> before_px;     ///< mean disparity; 0 where the first set did not see the pixel
  Image<float> after_px;      ///< mean disparity; 0 where the second set did not see the pixel
  Image<float> deviation_px;  ///< over time, of one frame before less one after; 0 where not judged
  Mask judged;  ///< set where both sets saw the pixel, within the margin, and its depth does not jump

  /// Share of the frames with a depth, before less after, -1 to 1; 0 in the margin. Above 0, depth went
  /// missing.
  Image<float> lost;

  /// Pixels that a person wants left out: nothing is found there. Empty for none.
  Mask left_out;

  /// Above 0, something came nearer. Of a pixel that is judged.
  [[nodiscard]] float change_px(std::size_t i) const { return after_px[i] - before_px[i]; }
};

/// Nothing is found in these pixels, nor is noise learnt from them, unless they are more than half of the
/// image: a small region that a person looks at is judged by what the rest of the view shows of the noise.
/// @param left_out of the change's size; empty for none
void leave_out(DisparityChange& change, Mask left_out);

/// Depth that went missing or came back is no evidence any more, as where a tool may have cut depth off.
void forget_losses(DisparityChange& change);

/// A pixel jumps when its deviation over time is more than ten times that of the median pixel: its matches
/// change between places far apart, and their mean is no depth.
///
/// @param initial, final      one size, one depth unit
/// @param disparity_by_depth  focal length times baseline: disparity in pixels times depth in depth units
[[nodiscard]] DisparityChange disparity_change(const DepthStatistics& initial, const DepthStatistics& final,
                                               double disparity_by_depth);

}  // namespace rva
