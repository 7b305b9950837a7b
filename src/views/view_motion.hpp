// Estimates from the depth images whether a camera moved between two captures.
#pragma once

#include <Eigen/Core>

#include "views/depth_view.hpp"

namespace rva {

/// The motion of the final camera relative to the initial one, estimated from the depth images alone. A pixel
/// by pixel comparison requires that both views are aligned within a fraction of a pixel.
struct ViewMotion {
  double displacement_px = 0.0;  ///< displacement of surfaces in the image: root mean square, px
  double uncertainty_px = 0.0;   ///< standard error of that
  /// Effective number of the 96 tiles of the image on which the estimate rests, weighted by their
  /// contributions: a change of a single object resembles a motion as well, but affects few tiles.
  double tiles = 0.0;
  int groups = 0;          ///< of adjacent contributing tiles, such as objects on a bare table
  double explained = 0.0;  ///< share of the change in those tiles that the motion explains
  /// Share of the pixels seen in both views that differ by more than a pixel of disparity from the
  /// median change.
  double differing = 0.0;

  /// True if the views are significantly displaced. Also false if nothing in view would show it: on a bare
  /// wall, a shift along the wall does not change depth.
  [[nodiscard]] bool noticed() const;
};

/// Fits the change of disparity by the effect of a small rigid motion through the slopes and edges of the
/// disparity image (range flow: Spies, Jaehne and Barron 2002), together with a drift of second degree, with
/// Tukey's biweight. The covariance is a sandwich estimate over tiles of the image (Liang and Zeger 1986),
/// since errors of neighbouring pixels are correlated. The fit is linear in the motion: displacements of more
/// than a few pixels are noticed, but not measured accurately; registration measures them (registration.hpp).
/// @param initial, final views of one camera
[[nodiscard]] ViewMotion view_motion(const DepthView& initial, const DepthView& final);

}  // namespace rva
