// Change between two sets of depth images, pixel by pixel, in disparity: the noise of a stereo camera is most
// uniform there, and a change of depth is weighted by how well the camera resolves it at that distance.
#pragma once

#include "depth/depth_statistics.hpp"
#include "depth/image.hpp"
#include "geometry/stereo_scale.hpp"

namespace rva {

/// Width of the border in which nothing is judged, since the matcher lacks half of its window there.
inline constexpr int margin_px = 6;

/// Whether a pixel has at least this distance from the border of the image.
/// @param margin px
[[nodiscard]] inline bool inside_margin(int u, int v, int width, int height, int margin = margin_px) {
  return u >= margin && v >= margin && u < width - margin && v < height - margin;
}

/// All images have the size of the statistics.
struct DisparityChange {
  /// No pixel is judged at first.
  DisparityChange(int width, int height)
      : before_px(width, height),
        after_px(width, height),
        deviation_px(width, height),
        judged(width, height),
        lost(width, height) {}

  std::size_t frames = 1;     ///< number of frames of the set that has fewer
  Image<float> before_px;     ///< mean disparity; 0 where the first set did not see the pixel
  Image<float> after_px;      ///< mean disparity; 0 where the second set did not see the pixel
  Image<float> deviation_px;  ///< over time, of the difference of two frames; 0 where not judged
  Mask judged;  ///< set where both sets saw the pixel, within the margin, and its depth does not jump

  /// Share of the frames with depth, before minus after, -1 to 1; 0 in the margin. Positive where depth
  /// went missing.
  Image<float> lost;

  /// Pixels left out by the user, in which nothing is found; empty for none.
  Mask left_out;

  /// Change of disparity of a judged pixel; positive where something came nearer.
  [[nodiscard]] float change_px(std::size_t i) const { return after_px[i] - before_px[i]; }
};

/// Leaves out pixels: nothing is found in them. Noise is not learnt from them either, unless they are more
/// than half of the image: a small region of interest is judged with the noise of the rest of the view.
/// @param left_out mask of the size of the change; empty for none
void leave_out(DisparityChange& change, Mask left_out);

/// Discards lost and regained depth as evidence, for captures in which a tool may have removed depth.
void forget_losses(DisparityChange& change);

/// Computes the change of mean disparity. Pixels whose deviation over time is more than ten times that of the
/// median pixel are not judged: their matches alternate between surfaces far apart, and their mean is no
/// depth of either.
///
/// @param initial, final statistics before and after, of one size and depth unit
/// @param stereo of both
[[nodiscard]] DisparityChange disparity_change(const DepthStatistics& initial, const DepthStatistics& final,
                                               const StereoScale& stereo);

}  // namespace rva
