// The scale of a stereo camera: how disparity, depth in metres, and stored depth convert.
#pragma once

namespace rva {

/// Disparity times depth is the focal length times the stereo baseline (equation 1 of docs/math.md).
struct StereoScale {
  double focal_baseline_m_px = 0.0;  ///< focal length in pixels times stereo baseline in metres
  double unit_m = 0.001;             ///< depth unit: metres of one step of the depth images

  /// @param depth_m along z, metres; not 0
  [[nodiscard]] constexpr double disparity_px(double depth_m) const { return focal_baseline_m_px / depth_m; }
  /// @param disparity_px not 0
  [[nodiscard]] constexpr double depth_m(double disparity_px) const {
    return focal_baseline_m_px / disparity_px;
  }
  /// Disparity in pixels times depth in depth units.
  [[nodiscard]] constexpr double focal_baseline_units_px() const { return focal_baseline_m_px / unit_m; }

  bool operator==(const StereoScale&) const = default;
};

}  // namespace rva
