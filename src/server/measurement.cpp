#include "server/measurement.hpp"

#include <cmath>

#include "core/quantile.hpp"

namespace rva {
namespace {

constexpr int reach_px = 2;

std::optional<double> depth_around(const LiveFrame& live, int u, int v) {
  const DepthImage& depth = live.frame.depth;
  std::vector<std::uint16_t> measured;
  std::size_t pixels = 0;
  for (int y = std::max(0, v - reach_px); y <= std::min(depth.height() - 1, v + reach_px); ++y) {
    for (int x = std::max(0, u - reach_px); x <= std::min(depth.width() - 1, u + reach_px); ++x) {
      ++pixels;
      if (depth(x, y) != no_depth) measured.push_back(depth(x, y));
    }
  }
  if (3 * measured.size() < pixels || measured.empty()) return std::nullopt;
  return quantile(measured, 0.5) * live.info.depth_unit_m;
}

/// A pixel of the depth image as a candidate for a pixel of the colour picture.
struct Candidate {
  Eigen::Vector2d pixel{0, 0};
  double off_px = 0.0;  ///< distance of its projection from the pixel of the colour picture
  double depth_m = 0.0;
};

// Where one surface hides another, the nearer one is visible.
bool is_better(const Candidate& a, const Candidate& b) {
  constexpr double same_px = 1.0;
  return a.off_px < b.off_px - same_px || (a.off_px < b.off_px + same_px && a.depth_m < b.depth_m);
}

std::optional<Candidate> candidate_at(const LiveFrame& live, int u, int v,
                                      const Eigen::Vector2d& color_pixel) {
  const std::uint16_t units = live.frame.depth(u, v);
  if (units == no_depth) return std::nullopt;
  Candidate candidate{{u, v}, 0.0, units * live.info.depth_unit_m};
  const Eigen::Vector3d point =
      *live.info.color_from_depth * live.info.depth.deproject(candidate.pixel, candidate.depth_m);
  if (point.z() <= 0.0) return std::nullopt;
  candidate.off_px = (live.info.color->project(point) - color_pixel).norm();
  return candidate;
}

// The pixel of the depth image whose surface is projected nearest to a pixel of the colour picture.
std::optional<Eigen::Vector2d> depth_pixel_of(const LiveFrame& live, const Eigen::Vector2d& color_pixel) {
  if (!live.info.color || !live.info.color_from_depth) return std::nullopt;
  constexpr double farthest_px = 3.0;
  std::optional<Candidate> best;
  for (int v = 0; v < live.frame.depth.height(); ++v) {
    for (int u = 0; u < live.frame.depth.width(); ++u) {
      const std::optional<Candidate> candidate = candidate_at(live, u, v, color_pixel);
      if (!candidate || candidate->off_px >= farthest_px) continue;
      if (!best || is_better(*candidate, *best)) best = candidate;
    }
  }
  return best ? std::optional(best->pixel) : std::nullopt;
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
