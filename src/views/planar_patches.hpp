// Approximates a view by a grid of small planes.
#pragma once

#include <Eigen/Core>
#include <concepts>

#include "geometry/stereo_scale.hpp"
#include "views/depth_view.hpp"

namespace rva {

/// A plane about the centre (u0, v0) of the patch: disparity = disparity_px + slope_u (u - u0) + slope_v (v -
/// v0). A plane in space is exactly a plane in disparity.
struct PlanarPatch {
  float disparity_px = 0.0F;  ///< at the centre; 0 where there is no plane
  float slope_u = 0.0F;       ///< px of disparity per px
  float slope_v = 0.0F;       ///< px of disparity per px
};

/// Patches on a grid of `step_px`, each fitted to a window of pixels around its centre. A patch is empty if
/// its window contains an edge, or has no disparity in more than half of its pixels.
class PlanarPatches {
 public:
  /// @param step_px   spacing of the grid
  /// @param window_px edge of a window, at least step_px
  PlanarPatches(const DepthView& view, int step_px, int window_px);

  /// Number of patches along u.
  [[nodiscard]] int columns() const { return patches_.width(); }
  /// Number of patches along v.
  [[nodiscard]] int rows() const { return patches_.height(); }
  /// The patch of a column and row of the grid, which may be empty.
  [[nodiscard]] const PlanarPatch& at(int column, int row) const { return patches_(column, row); }
  /// The patch in whose cell a pixel lies; null outside the image and where there is no plane.
  template <std::floating_point Number>
  [[nodiscard]] const PlanarPatch* find(Number u, Number v) const {
    // Compared before the conversion to int, which values far outside would overflow.
    constexpr auto left = static_cast<Number>(-0.5);
    if (!(u > left && v > left && u < static_cast<Number>(camera_.width) &&
          v < static_cast<Number>(camera_.height)))
      return nullptr;
    const int column = index_of(u);
    const int row = index_of(v);
    if (column >= columns() || row >= rows()) return nullptr;
    const PlanarPatch& patch = patches_(column, row);
    return patch.disparity_px > 0.0F ? &patch : nullptr;
  }
  /// Pixel at the centre of a column or row of the grid.
  [[nodiscard]] double centre_px(int index) const { return step_px_ * (index + 0.5) - 0.5; }
  /// Disparity of the plane of a patch at a pixel of its cell.
  template <std::floating_point Number>
  [[nodiscard]] Number disparity_px(const PlanarPatch& patch, Number u, Number v) const {
    const Number du = u - static_cast<Number>(centre_px(index_of(u)));
    const Number dv = v - static_cast<Number>(centre_px(index_of(v)));
    return static_cast<Number>(patch.disparity_px) + static_cast<Number>(patch.slope_u) * du +
           static_cast<Number>(patch.slope_v) * dv;
  }

  /// Intrinsics of the view.
  [[nodiscard]] const Intrinsics& camera() const { return camera_; }
  /// Between depth and disparity of the view.
  [[nodiscard]] const StereoScale& stereo() const { return stereo_; }

 private:
  // Pixels of the image are at least -0.5, so that truncation rounds down.
  template <std::floating_point Number>
  [[nodiscard]] int index_of(Number pixel) const {
    return static_cast<int>((pixel + static_cast<Number>(0.5)) * static_cast<Number>(by_step_px_));
  }

  int step_px_;
  double by_step_px_;
  Intrinsics camera_;
  StereoScale stereo_;
  Image<PlanarPatch> patches_;
};

}  // namespace rva
