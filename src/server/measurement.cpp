#include "server/measurement.hpp"

#include <cmath>
#include <limits>

#include "core/quantile.hpp"

namespace rva {
namespace {

constexpr int reach_px = 2;

std::optional<double> depth_around(const LiveFrame& live, int u, int v) {
  const DepthImage& depth = live.frame.depth;
  std::vector<std::uint16_t> measured;
  std::size_t looked_at = 0;
  for (int y = std::max(0, v - reach_px); y <= std::min(depth.height() - 1, v + reach_px); ++y) {
    for (int x = std::max(0, u - reach_px); x <= std::min(depth.width() - 1, u + reach_px); ++x) {
      ++looked_at;
      if (depth(x, y) != no_depth) measured.push_back(depth(x, y));
    }
  }
  if (3 * measured.size() < looked_at || measured.empty()) return std::nullopt;
  return quantile(measured, 0.5) * live.info.depth_unit_m;
}

// The pixel of the depth image whose surface the colour imager sees nearest to the place.
std::optional<Eigen::Vector2d> depth_pixel_of(const LiveFrame& live, const Eigen::Vector2d& color_pixel) {
  const CaptureInfo& info = live.info;
  if (!info.color || !info.color_from_depth) return std::nullopt;
  const DepthImage& depth = live.frame.depth;
  constexpr double farthest_px = 3.0;
  double nearest_px = farthest_px;
  double nearest_m = std::numeric_limits<double>::infinity();
  std::optional<Eigen::Vector2d> found;
  for (int v = 0; v < depth.height(); ++v) {
    for (int u = 0; u < depth.width(); ++u) {
      if (depth(u, v) == no_depth) continue;
      const double depth_m = depth(u, v) * info.depth_unit_m;
      const Eigen::Vector3d point = *info.color_from_depth * info.depth.deproject({u, v}, depth_m);
      if (point.z() <= 0.0) continue;
      const double off_px = (info.color->project(point) - color_pixel).norm();
      // Where one surface hides another, the nearer is seen.
      constexpr double same_px = 1.0;
      const bool better =
          off_px < nearest_px - same_px || (off_px < nearest_px + same_px && depth_m < nearest_m);
      if (off_px >= farthest_px || !better) continue;
      nearest_px = off_px;
      nearest_m = depth_m;
      found = {u, v};
    }
  }
  return found;
}

}  // namespace

std::optional<MeasuredPoint> measure(const LiveFrame& live, Stream stream, const Eigen::Vector2d& pixel) {
  if (!pixel.allFinite()) return std::nullopt;
  const std::optional<Eigen::Vector2d> at = stream == Stream::color ? depth_pixel_of(live, pixel) : pixel;
  if (!at || !live.info.depth.contains(*at)) return std::nullopt;
  const std::optional<double> depth_m =
      depth_around(live, static_cast<int>(std::lround(at->x())), static_cast<int>(std::lround(at->y())));
  if (!depth_m) return std::nullopt;
  MeasuredPoint point;
  point.position_m = live.info.depth.deproject(*at, *depth_m);
  point.distance_m = point.position_m.norm();
  return point;
}

}  // namespace rva
