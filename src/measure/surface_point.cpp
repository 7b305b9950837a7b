#include "measure/surface_point.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "core/quantile.hpp"
#include "measure/disparity_plane.hpp"

namespace rva {
namespace {

/// Neighbours on one surface differ by less, as in supported() of the map.
constexpr float one_surface_px = 1.0F;
/// Where less of the surroundings shows the same surface, an edge is near.
constexpr double least_share = 0.8;

/// The pixels around one, as far as the image reaches.
struct Window {
  std::vector<Eigen::Vector2i> seen;
  std::size_t pixels = 0;
};

Window window_around(const UncertainView& view, const Eigen::Vector2i& middle, int reach_px) {
  Window window;
  for (int v = std::max(0, middle.y() - reach_px);
       v <= std::min(view.camera.height - 1, middle.y() + reach_px); ++v) {
    for (int u = std::max(0, middle.x() - reach_px);
         u <= std::min(view.camera.width - 1, middle.x() + reach_px); ++u) {
      ++window.pixels;
      if (view.seen(u, v)) window.seen.emplace_back(u, v);
    }
  }
  return window;
}

float median_px(const UncertainView& view, const std::vector<Eigen::Vector2i>& pixels) {
  std::vector<float> values;
  for (const Eigen::Vector2i& pixel : pixels) values.push_back(view.disparity_px(pixel.x(), pixel.y()));
  return quantile(values, 0.5);
}

// The surface in the middle: of the nearest pixels, or of all where too few of those are measured.
SurfacePixels surface_in_middle(const UncertainView& view, const Window& window,
                                const Eigen::Vector2i& middle) {
  constexpr std::size_t enough = 3;
  const Window nearest = window_around(view, middle, 1);
  const float level_px = median_px(view, nearest.seen.size() >= enough ? nearest.seen : window.seen);
  SurfacePixels surface;
  for (const Eigen::Vector2i& pixel : window.seen) {
    if (std::abs(view.disparity_px(pixel.x(), pixel.y()) - level_px) < one_surface_px)
      surface.pixels.push_back(pixel);
  }
  surface.weights.assign(surface.pixels.size(), 1.0);
  return surface;
}

/// What is around a point's pixels.
struct Surroundings {
  double scatter_px = 0.0;  ///< of the disparities of the same surface about a plane
  double share = 0.0;       ///< of the pixels that show the same surface
};

Surroundings surroundings_of(const UncertainView& view, const Eigen::Vector2i& middle,
                             const Eigen::Vector3d& coefficients, const Eigen::Vector3d& ray) {
  constexpr int reach_px = 5;  // half of a matcher's window
  const Window window = window_around(view, middle, reach_px);
  SurfacePixels same;
  for (const Eigen::Vector2i& pixel : window.seen) {
    Eigen::Vector3d apart = view.ray(pixel.cast<double>()) - ray;
    apart.z() = 1.0;
    if (std::abs(view.disparity_px(pixel.x(), pixel.y()) - coefficients.dot(apart)) < one_surface_px)
      same.pixels.push_back(pixel);
  }
  same.weights.assign(same.pixels.size(), 1.0);
  return {scatter_px(view, same, ray),
          static_cast<double>(same.pixels.size()) / static_cast<double>(window.pixels)};
}

// Equations 79 and 80 of docs/math.md.
SurfacePoint point_on(const DisparityPlane& plane, const UncertainView& view, const Eigen::Vector3d& ray,
                      const MeasureOptions& options) {
  const double disparity_px = plane.coefficients.z();
  const double depth_m = view.stereo.depth_m(disparity_px);
  const double relative_variance = plane.covariance(2, 2) / (disparity_px * disparity_px);
  SurfacePoint point{depth_m * ray, {}};
  point.covariance_m2 = relative_variance * point.position_m * point.position_m.transpose();
  const Eigen::Vector2d pointing =
      options.pointing_px * Eigen::Vector2d(1.0 / view.camera.fx, 1.0 / view.camera.fy);
  for (int axis = 0; axis < 2; ++axis) {
    const Eigen::Vector3d shift =
        pointing[axis] *
        (depth_m * Eigen::Vector3d::Unit(axis) - plane.coefficients[axis] / disparity_px * point.position_m);
    point.covariance_m2 += shift * shift.transpose();
  }
  return point;
}

}  // namespace

PointOrReason surface_point(const UncertainView& view, const Eigen::Vector2d& pixel,
                            const MeasureOptions& options, int reach_px) {
  if (!pixel.allFinite() || !view.camera.contains(pixel)) return Unmeasured::outside;
  const Eigen::Vector2i middle(static_cast<int>(std::lround(pixel.x())),
                               static_cast<int>(std::lround(pixel.y())));
  const Window window = window_around(view, middle, reach_px);
  if (window.seen.empty() || 3 * window.seen.size() < window.pixels) return Unmeasured::missing_depth;
  const SurfacePixels surface = surface_in_middle(view, window, middle);
  if (3 * surface.pixels.size() < window.pixels) return Unmeasured::edge;
  const Eigen::Vector3d ray = view.ray(pixel);
  const Surroundings around = surroundings_of(view, middle, disparity_coefficients(view, surface, ray), ray);
  const DisparityPlane plane = fit_disparities(view, surface, ray, around.scatter_px);
  if (plane.coefficients.z() <= 0.0) return Unmeasured::edge;
  SurfacePoint point = point_on(plane, view, ray, options);
  point.near_edge = around.share < least_share;
  return point;
}

}  // namespace rva
