#include "measure/profile.hpp"

#include <algorithm>
#include <cmath>

#include "core/units.hpp"

namespace rva {
namespace {

constexpr int most_samples = 400;
/// Narrower than that of a point, so that small steps stay visible.
constexpr int sample_reach_px = 1;

/// The line through both ends, and the direction of heights above it.
struct Base {
  SurfacePoint from;
  SurfacePoint to;
  Eigen::Vector3d along;  // unit length
  Eigen::Vector3d up;     // unit length, square to `along`, towards the camera
  double length_m = 0.0;
};

std::optional<Base> base_between(const SurfacePoint& from, const SurfacePoint& to) {
  const Eigen::Vector3d apart_m = to.position_m - from.position_m;
  const double length_m = apart_m.norm();
  if (length_m <= 0.0) return std::nullopt;
  const Eigen::Vector3d along = apart_m / length_m;
  const Eigen::Vector3d to_camera = -(from.position_m + to.position_m);
  const Eigen::Vector3d up = to_camera - along.dot(to_camera) * along;
  if (up.norm() <= 1e-6 * to_camera.norm()) return std::nullopt;  // the line leads into the camera
  return Base{from, to, along, up.normalized(), length_m};
}

// Equation 86 of docs/math.md.
ProfilePoint point_above(const Base& base, const SurfacePoint& point, const MeasureOptions& options) {
  const Eigen::Vector3d from_start_m = point.position_m - base.from.position_m;
  const double along_m = base.along.dot(from_start_m);
  const double height_m = base.up.dot(from_start_m);
  const double share = along_m / base.length_m;
  const auto variance = [&](const SurfacePoint& of) { return base.up.dot(of.covariance_m2 * base.up); };
  const double scale_m = options.calibration_share * height_m;
  const double variance_m2 = variance(point) + (1.0 - share) * (1.0 - share) * variance(base.from) +
                             share * share * variance(base.to) + scale_m * scale_m;
  return {mm_per_m * along_m, {mm_per_m * height_m, mm_per_m * std::sqrt(variance_m2)}};
}

}  // namespace

ProfileOrReason profile_along(const UncertainView& view, const Eigen::Vector2d& from,
                              const Eigen::Vector2d& to, const MeasureOptions& options) {
  const PointOrReason first = surface_point(view, from, options);
  if (const auto* reason = std::get_if<Unmeasured>(&first)) return *reason;
  const PointOrReason last = surface_point(view, to, options);
  if (const auto* reason = std::get_if<Unmeasured>(&last)) return *reason;
  const std::optional<Base> base = base_between(std::get<SurfacePoint>(first), std::get<SurfacePoint>(last));
  if (!base) return Unmeasured::collinear;
  Profile profile{length_between(base->from, base->to, options), {}};
  const int steps = std::clamp(static_cast<int>(std::ceil((to - from).norm())), 1, most_samples - 1);
  for (int i = 0; i <= steps; ++i) {
    const double share = static_cast<double>(i) / steps;
    const PointOrReason here = surface_point(view, from + share * (to - from), options, sample_reach_px);
    const auto* point = std::get_if<SurfacePoint>(&here);
    profile.samples.push_back(
        {share, point != nullptr ? std::optional(point_above(*base, *point, options)) : std::nullopt});
  }
  return profile;
}

}  // namespace rva
