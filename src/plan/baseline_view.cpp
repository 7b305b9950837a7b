#include "plan/baseline_view.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/quantile.hpp"

namespace rva {
namespace {

constexpr float not_inspected = std::numeric_limits<float>::quiet_NaN();

// Methods without a level of detection inspect what both sides measured.
Image<float> levels_of(const Detection& detection) {
  if (detection.level_of_detection) return detection.level_of_detection->least_mm;
  Image<float> least_mm(detection.final_m.width(), detection.final_m.height(), not_inspected);
  for (std::size_t i = 0; i < least_mm.size(); ++i) {
    if (detection.final_m[i] > 0.0F && !is_left_out(detection.left_out, i)) least_mm[i] = 0.0F;
  }
  return least_mm;
}

}  // namespace

BaselineView::BaselineView(const Detection& detection, const ComparedCameras& cameras)
    : cameras_(cameras),
      initial_from_final_(detection.findings.final_from_initial.inverse()),
      stood_still_(cameras.initial == cameras.final &&
                   initial_from_final_.isApprox(Transform::Identity(), 1e-12)) {
  Image<float> least_mm = levels_of(detection);
  if (stood_still_) {
    depth_m_ = detection.final_m;
    least_mm_ = std::move(least_mm);
    return;
  }
  depth_m_ = Image<float>(cameras.initial.width, cameras.initial.height);
  least_mm_ = Image<float>(cameras.initial.width, cameras.initial.height, not_inspected);
  transfer(detection, least_mm);
}

void BaselineView::transfer(const Detection& detection, const Image<float>& least_mm) {
  for (int v = 0; v < least_mm.height(); ++v) {
    for (int u = 0; u < least_mm.width(); ++u) {
      const double final_m = detection.final_m(u, v);
      if (final_m > 0.0) add(initial_from_final_ * cameras_.final.deproject({u, v}, final_m), least_mm(u, v));
    }
  }
}

// Several points may fall on one pixel of the baseline: the camera sees the nearest.
void BaselineView::add(const Eigen::Vector3d& point, float level_mm) {
  if (point.z() <= 0.0) return;
  const Eigen::Vector2d pixel = cameras_.initial.project(point);
  if (!cameras_.initial.contains(pixel)) return;
  const auto x = static_cast<int>(std::lround(pixel.x()));
  const auto y = static_cast<int>(std::lround(pixel.y()));
  const auto depth_m = static_cast<float>(point.z());
  if (depth_m_(x, y) > 0.0F && depth_m_(x, y) <= depth_m) return;
  depth_m_(x, y) = depth_m;
  least_mm_(x, y) = level_mm;
}

std::optional<Eigen::Vector2d> BaselineView::at(const Eigen::Vector2d& final_pixel,
                                                std::optional<double> depth_m) const {
  if (stood_still_) return final_pixel;
  if (!depth_m) return std::nullopt;
  const Eigen::Vector3d point = initial_from_final_ * cameras_.final.deproject(final_pixel, *depth_m);
  if (point.z() <= 0.0) return std::nullopt;
  return cameras_.initial.project(point);
}

std::optional<double> BaselineView::level_mm(const Eigen::Vector2d& pixel) const {
  constexpr int around_px = 4;  // half of a matcher's window
  const auto at_u = static_cast<int>(std::lround(pixel.x()));
  const auto at_v = static_cast<int>(std::lround(pixel.y()));
  std::vector<float> levels_mm;
  std::size_t looked_at = 0;
  for (int v = std::max(0, at_v - around_px); v <= std::min(least_mm_.height() - 1, at_v + around_px); ++v) {
    for (int u = std::max(0, at_u - around_px); u <= std::min(least_mm_.width() - 1, at_u + around_px); ++u) {
      // Where the views differ, single pixels of the baseline show none of the final view.
      if (!stood_still_ && depth_m_(u, v) <= 0.0F) continue;
      ++looked_at;
      if (!std::isnan(least_mm_(u, v))) levels_mm.push_back(least_mm_(u, v));
    }
  }
  if (levels_mm.empty() || 4 * levels_mm.size() < looked_at) return std::nullopt;
  return quantile(levels_mm, 0.25);
}

}  // namespace rva
