// Whether a camera stood still between two captures, as the depth images show it.
#pragma once

#include <Eigen/Core>

#include "cloud/depth_view.hpp"

namespace rva {

/// What a pixel by pixel comparison rests on: that both views lie over each other within a fraction of a
/// pixel. The motion of the final camera against the initial one is estimated from the depth images alone.
struct ViewMotion {
  double displacement_px = 0.0;  ///< how far surfaces moved in the image: root mean square over both views
  double uncertainty_px = 0.0;   ///< standard error of that
  /// How many of the 96 tiles of the image hold the estimate, weighted by what each contributes: a change of
  /// a single object looks like a motion, too, but in few tiles.
  double tiles = 0.0;
  int groups = 0;          ///< of such tiles that touch each other: objects on a bare table, say
  double explained = 0.0;  ///< share of the change in those tiles that the motion explains
  /// Share of what both views see that differs by more than a pixel of disparity about the median change.
  double differing = 0.0;

  /// True where the views are shown to be displaced. False also where nothing in view would show it: on a
  /// bare wall a shift along the wall changes no depth.
  [[nodiscard]] bool noticed() const;
};

/// Change of disparity is fitted by what a small rigid motion would cause, through the image's own slopes and
/// edges of disparity (range flow: Spies, Jaehne and Barron 2002), beside a drift of second degree, with
/// Tukey's biweight. The covariance is a sandwich over tiles of the image (Liang and Zeger 1986), since
/// errors of neighbours have much in common. It is linear in the motion: displacements of more than a few
/// pixels are noticed, not measured; registration measures them (registration.hpp).
/// @param initial, final of one camera; a pixel has seen the same surface in both, or has not
[[nodiscard]] ViewMotion view_motion(const DepthView& initial, const DepthView& final);

}  // namespace rva
