#include "views/fused_change.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/parallel.hpp"
#include "views/drift.hpp"
#include "views/fused_view.hpp"

namespace rva {
namespace {

// Disparities that differ by more are on another surface.
constexpr float one_surface_px = 1.2F;
constexpr float least_px = 1e-3F;  // lower limit of a valid disparity

void take_off_drift(DisparityChange& change) {
  const Image<float> drift_px = fit_drift(change).px();
  for (std::size_t i = 0; i < drift_px.size(); ++i) {
    if (change.before_px[i] > 0.0F)
      change.before_px[i] = std::max(change.before_px[i] + drift_px[i], least_px);
  }
}

DepthView after(const std::vector<PlacedChange>& changes, const Intrinsics& camera,
                const StereoScale& stereo) {
  std::vector<PlacedView> views;
  for (const PlacedChange& of : changes)
    views.push_back({{camera, stereo, of.change.after_px, of.change.deviation_px}, of.first_from_view});
  return fuse(views);
}

/// Sums over the views for one point of the surface.
struct Sums {
  float before_px = 0.0F;  // of any view that has one
  float change_px = 0.0F;
  float variance_px2 = 0.0F;
  float count = 0.0F;
};

class Fusion {
 public:
  Fusion(std::vector<PlacedChange> changes, const Intrinsics& camera, const StereoScale& stereo)
      : changes_(std::move(changes)), surface_(after(changes_, camera, stereo)) {
    for (const PlacedChange& of : changes_) view_from_first_.emplace_back(of.first_from_view.inverse());
  }

  [[nodiscard]] DisparityChange run() const {
    const DisparityChange& first = changes_.front().change;
    DisparityChange fused(surface_.camera.width, surface_.camera.height);
    fused.frames = first.frames * changes_.size();
    fused.lost = first.lost;
    parallel_bands(surface_.camera.height, [&](int begin, int end) {
      for (int v = begin; v < end; ++v) {
        for (int u = 0; u < surface_.camera.width; ++u) fill(u, v, fused);
      }
    });
    return fused;
  }

 private:
  // Equation 47 of docs/math.md.
  void fill(int u, int v, DisparityChange& fused) const {
    const float after_px = surface_.disparity_px(u, v);
    if (after_px <= 0.0F) return;
    fused.after_px(u, v) = after_px;
    const Eigen::Vector3d point =
        surface_.camera.deproject({u, v}, surface_.stereo.depth_m(static_cast<double>(after_px)));
    Sums sums;
    for (std::size_t k = 0; k < changes_.size(); ++k)
      add(changes_[k].change, view_from_first_[k] * point, sums);
    fused.before_px(u, v) = sums.before_px;
    const float least = 0.5F * static_cast<float>(changes_.size());
    const Intrinsics& camera = surface_.camera;
    if (sums.count < least || !inside_margin(u, v, camera.width, camera.height)) return;
    fused.before_px(u, v) = std::max(after_px - sums.change_px / sums.count, least_px);
    fused.deviation_px(u, v) = std::sqrt(sums.variance_px2 / sums.count);
    fused.judged(u, v) = mask_set;
  }

  // Uses the nearest pixel, without interpolation: a change hardly varies within a pixel.
  void add(const DisparityChange& change, const Eigen::Vector3d& point, Sums& sums) const {
    if (point.z() <= 0.0) return;
    const Eigen::Vector2d pixel = surface_.camera.project(point);
    if (!surface_.camera.contains(pixel)) return;
    const auto u = static_cast<int>(std::lround(pixel.x()));
    const auto v = static_cast<int>(std::lround(pixel.y()));
    const float after_px = change.after_px(u, v);
    const float before_px = change.before_px(u, v);
    const auto wanted_px = static_cast<float>(surface_.stereo.disparity_px(point.z()));
    if (after_px <= 0.0F || before_px <= 0.0F || std::abs(after_px - wanted_px) > one_surface_px) return;
    sums.before_px = before_px;
    if (change.judged(u, v) == 0) return;
    sums.change_px += after_px - before_px;
    sums.variance_px2 += change.deviation_px(u, v) * change.deviation_px(u, v);
    sums.count += 1.0F;
  }

  std::vector<PlacedChange> changes_;
  DepthView surface_;
  std::vector<Transform> view_from_first_;
};

}  // namespace

DisparityChange fuse(std::vector<PlacedChange> changes, const Intrinsics& camera, const StereoScale& stereo) {
  assert(!changes.empty());
  if (changes.size() == 1) return std::move(changes.front().change);
  for (PlacedChange& of : changes) take_off_drift(of.change);
  return Fusion(std::move(changes), camera, stereo).run();
}

}  // namespace rva
