// Infrared pairs of many poses, matched at the same places: costs of disparities about a surface.
#pragma once

#include <span>
#include <vector>

#include "depth/image.hpp"
#include "geometry/transform.hpp"
#include "infrared/reference_surface.hpp"

namespace rva {

/// The rectified pair of a capture, as of log_grey(): speckle multiplies light, so that in the logarithm it
/// weighs the same everywhere.
struct StereoView {
  Image<float> left;
  Image<float> right;
  Transform view_from_reference = Transform::Identity();  ///< of the left imager
  double excess_px = 0.0;  ///< disparity of this pair beyond that of the surface: temperature bends cameras
};

/// Labels are disparities of the reference view beside those of a start surface.
struct SweepOptions {
  int window_px = 5;      ///< edge of the window that costs are summed over, odd
  double range_px = 3.0;  ///< to either side of the start
  double step_px = 0.25;  ///< a whole number of steps is a pixel
};

/// How badly the pairs agree with each label, for each pixel of the reference.
class SweptCosts {
 public:
  SweptCosts(int width, int height, const SweepOptions& options);

  [[nodiscard]] int labels() const { return labels_; }
  /// Disparity beside the start.
  [[nodiscard]] float offset_px(float label) const { return first_px_ + label * step_px_; }

  /// Sums over the pairs of the squared difference of log brightness between left and right, over the window,
  /// the window's mean difference apart.
  [[nodiscard]] std::span<const float> at(int u, int v) const { return {row(u, v), row(u, v) + labels_}; }
  [[nodiscard]] std::span<float> at(int u, int v) {
    float* const first = costs_.data() + index(u, v);
    return {first, first + labels_};
  }

  /// Differences that each sum is made of: pixels of the window over all pairs that see it, less one a pair.
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

/// Plane sweep about a surface that windows follow, so that slopes do not tear them.
/// @param start          of the reference
/// @param disparity_m_px focal length times baseline
/// @param views          at least one, of the start's size
[[nodiscard]] SweptCosts sweep(const ReferenceSurface& start, double disparity_m_px,
                               std::span<const StereoView> views, const SweepOptions& options = {});

/// How far the disparity of each pair is from that of the surface, in the middle of all it sees: a camera's
/// temperature shifts it by a tenth of a pixel from capture to capture. Set in `views`.
void align_disparities(const ReferenceSurface& surface, double disparity_m_px, std::span<StereoView> views);

/// The least of some costs, between labels by a parabola through the least one and its neighbours.
struct Minimum {
  float label = 0.0F;
  float cost = 0.0F;
  float rise = 0.0F;  ///< of the cost, one label beside the least, on the parabola; 0 where there is none
};
[[nodiscard]] Minimum minimum_of(std::span<const float> costs);

struct SpaceTimeOptions {
  SweepOptions coarse{.window_px = 5, .range_px = 4.0, .step_px = 0.5};
  SweepOptions fine{.window_px = 5, .range_px = 1.0, .step_px = 0.25};
};

}  // namespace rva
