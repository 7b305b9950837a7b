// Plane sweep: matching costs of infrared pairs of many poses, at the pixels of one reference view.
#pragma once

#include <span>
#include <vector>

#include "depth/image.hpp"
#include "geometry/stereo_scale.hpp"
#include "geometry/transform.hpp"
#include "infrared/reference_surface.hpp"

namespace rva {

/// The rectified pair of a capture, as returned by log_grey(): speckle multiplies light, so that in the
/// logarithm its contrast is independent of brightness.
struct StereoView {
  Image<float> left;                                      ///< left image
  Image<float> right;                                     ///< right image
  Transform view_from_reference = Transform::Identity();  ///< of the left imager
  double excess_px = 0.0;  ///< disparity of this pair minus that of the surface, due to temperature
};

/// Labels are disparities of the reference view relative to those of a start surface.
struct SweepOptions {
  int window_px = 5;      ///< edge of the window over which costs are summed, odd
  double range_px = 3.0;  ///< range of labels to either side of the start
  double step_px = 0.25;  ///< spacing of labels; a pixel is a whole number of steps
};

/// Costs of each label for each pixel of the reference: how badly it explains the pairs.
class SweptCosts {
 public:
  /// All costs and degrees of freedom are 0.
  /// @param width, height size of the reference view, px
  SweptCosts(int width, int height, const SweepOptions& options);

  /// Number of labels per pixel.
  [[nodiscard]] int labels() const { return labels_; }
  /// Disparity of a label relative to the start, in pixels; labels may be fractional.
  [[nodiscard]] float offset_px(float label) const { return first_px_ + label * step_px_; }

  /// Costs of all labels at a pixel: sums over the pairs of the squared difference of log brightness between
  /// left and right, over the window, without the mean difference of the window.
  [[nodiscard]] std::span<const float> at(int u, int v) const { return {row(u, v), row(u, v) + labels_}; }
  /// @overload
  [[nodiscard]] std::span<float> at(int u, int v) {
    float* const first = costs_.data() + index(u, v);
    return {first, first + labels_};
  }

  /// Degrees of freedom of each sum: pixels of the window over all pairs that see it, minus one for
  /// each pair.
  Image<float> freedom;

 private:
  [[nodiscard]] std::size_t index(int u, int v) const {
    return (static_cast<std::size_t>(v) * static_cast<std::size_t>(freedom.width()) +
            static_cast<std::size_t>(u)) *
           static_cast<std::size_t>(labels_);
  }
  [[nodiscard]] const float* row(int u, int v) const { return costs_.data() + index(u, v); }

  int labels_;
  float first_px_;
  float step_px_;
  std::vector<float> costs_;
};

/// Computes costs about a surface. Windows follow the surface, so that sloped surfaces are matched
/// without distortion.
/// @param start          surface in the reference view
/// @param views          at least one, of the size of the start
[[nodiscard]] SweptCosts sweep(const ReferenceSurface& start, const StereoScale& stereo,
                               std::span<const StereoView> views, const SweepOptions& options = {});

/// Adds to excess_px of each pair the median difference of its disparity from that of the surface. The
/// temperature of a camera shifts it by a tenth of a pixel from capture to capture.
void align_disparities(const ReferenceSurface& surface, const StereoScale& stereo,
                       std::span<StereoView> views);

/// The minimum of some costs, interpolated between labels by a parabola through the least one and
/// its neighbours.
struct Minimum {
  float label = 0.0F;  ///< position among the labels, with a fraction
  float cost = 0.0F;   ///< value of the parabola there, at least 0
  float rise = 0.0F;   ///< of the parabola one label beside the minimum; 0 if there is no parabola
};

/// The minimum of the costs of one pixel.
/// @param costs at least one; an end of the range is not interpolated
[[nodiscard]] Minimum minimum_of(std::span<const float> costs);

/// Settings of space-time stereo: a coarse sweep of disparities, then a fine one about its result.
struct SpaceTimeOptions {
  SweepOptions coarse{.window_px = 5, .range_px = 4.0, .step_px = 0.5};  ///< about the start surface
  /// About the result of the coarse sweep.
  SweepOptions fine{.window_px = 5, .range_px = 1.0, .step_px = 0.25};
};

}  // namespace rva
