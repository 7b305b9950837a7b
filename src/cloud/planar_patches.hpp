// A view as a grid of small planes.
#pragma once

#include <Eigen/Core>

#include "cloud/depth_view.hpp"

namespace rva {

/// disparity = disparity_px + slope_u (u - u0) + slope_v (v - v0) about its centre: a plane in space is one
/// in disparity, exactly.
struct PlanarPatch {
  float disparity_px = 0.0F;  ///< at the centre; 0 where there is no plane
  float slope_u = 0.0F;       ///< px of disparity per px
  float slope_v = 0.0F;
};

/// Patches on a grid of `step_px`, each fitted to a window of pixels around its centre. Where a window holds
/// an edge, or holes in more than half of it, there is none.
class PlanarPatches {
 public:
  /// @param step_px   of the grid; window_px not below it
  PlanarPatches(const DepthView& view, int step_px, int window_px);

  [[nodiscard]] int columns() const { return patches_.width(); }
  [[nodiscard]] int rows() const { return patches_.height(); }
  [[nodiscard]] const PlanarPatch& at(int column, int row) const { return patches_(column, row); }
  /// The patch in whose cell a pixel lies; null outside the image and where there is no plane.
  [[nodiscard]] const PlanarPatch* find(double u, double v) const;
  /// Pixel at the centre of a column or row of the grid.
  [[nodiscard]] double centre_px(int index) const { return step_px_ * (index + 0.5) - 0.5; }
  /// What the patch's plane has at a pixel of its cell.
  [[nodiscard]] double disparity_px(const PlanarPatch& patch, double u, double v) const;

  [[nodiscard]] const Intrinsics& camera() const { return camera_; }
  [[nodiscard]] double disparity_m_px() const { return disparity_m_px_; }

 private:
  [[nodiscard]] int index_of(double pixel) const;

  int step_px_;
  Intrinsics camera_;
  double disparity_m_px_;
  Image<PlanarPatch> patches_;
};

}  // namespace rva
