#include "views/planar_patches.hpp"

#include <algorithm>
#include <cmath>

#include "core/parallel.hpp"

namespace rva {
namespace {

// Largest deviation from the plane, root mean square; beyond it, a window contains an edge or a wrong match.
constexpr double planar_px = 0.4;

/// Sums over a window for fitting a plane by least squares.
class PlaneFit {
 public:
  void add(double u, double v, double d) {
    n_ += 1.0;
    u_ += u;
    v_ += v;
    d_ += d;
    uu_ += u * u;
    uv_ += u * v;
    vv_ += v * v;
    ud_ += u * d;
    vd_ += v * d;
    dd_ += d * d;
  }

  // The plane about (0, 0); empty if the pixels do not lie on one.
  // Equation 31 of docs/math.md.
  [[nodiscard]] PlanarPatch plane(double least_pixels) const {
    if (n_ < least_pixels) return {};
    const double uu = uu_ - u_ * u_ / n_;
    const double uv = uv_ - u_ * v_ / n_;
    const double vv = vv_ - v_ * v_ / n_;
    const double ud = ud_ - u_ * d_ / n_;
    const double vd = vd_ - v_ * d_ / n_;
    const double dd = dd_ - d_ * d_ / n_;
    const double determinant = uu * vv - uv * uv;
    if (determinant < 0.25 * n_ * n_) return {};  // the pixels are nearly collinear
    const double slope_u = (ud * vv - vd * uv) / determinant;
    const double slope_v = (vd * uu - ud * uv) / determinant;
    const double left = dd - slope_u * ud - slope_v * vd;
    if (left > planar_px * planar_px * n_) return {};
    const double centre = (d_ - slope_u * u_ - slope_v * v_) / n_;
    if (centre <= 0.0) return {};
    return {static_cast<float>(centre), static_cast<float>(slope_u), static_cast<float>(slope_v)};
  }

 private:
  double n_ = 0.0, u_ = 0.0, v_ = 0.0, d_ = 0.0;
  double uu_ = 0.0, uv_ = 0.0, vv_ = 0.0, ud_ = 0.0, vd_ = 0.0, dd_ = 0.0;
};

PlanarPatch fit(const DepthView& view, double centre_u, double centre_v, int window_px) {
  const double half = 0.5 * window_px;
  const int left = std::max(0, static_cast<int>(std::ceil(centre_u - half)));
  const int right = std::min(view.camera.width - 1, static_cast<int>(std::floor(centre_u + half)));
  const int top = std::max(0, static_cast<int>(std::ceil(centre_v - half)));
  const int bottom = std::min(view.camera.height - 1, static_cast<int>(std::floor(centre_v + half)));
  PlaneFit sums;
  for (int v = top; v <= bottom; ++v) {
    for (int u = left; u <= right; ++u) {
      const float d = view.disparity_px(u, v);
      if (d > 0.0F) sums.add(u - centre_u, v - centre_v, static_cast<double>(d));
    }
  }
  return sums.plane(0.5 * window_px * window_px);
}

}  // namespace

PlanarPatches::PlanarPatches(const DepthView& view, int step_px, int window_px)
    : step_px_(step_px),
      by_step_px_(1.0 / step_px),
      camera_(view.camera),
      stereo_(view.stereo),
      patches_(view.camera.width / step_px, view.camera.height / step_px) {
  parallel_bands(rows(), [&](int first, int end) {
    for (int row = first; row < end; ++row) {
      for (int column = 0; column < columns(); ++column)
        patches_(column, row) = fit(view, centre_px(column), centre_px(row), window_px);
    }
  });
}

}  // namespace rva
