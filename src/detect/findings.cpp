#include "detect/findings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/quantile.hpp"

namespace rva {
namespace {

constexpr double mm_per_m = 1000.0;

/// Depth over a region, as far as it was measured.
struct RegionDepth {
  std::vector<float> depths_m;   // after; before, where there is none after
  std::vector<float> heights_m;  // where there are both
  std::size_t lost = 0;          // pixels without a depth after
};

RegionDepth depth_of(const std::vector<std::uint32_t>& pixels, const Comparison& comparison) {
  RegionDepth depth;
  for (const std::uint32_t i : pixels) {
    const float before_m = comparison.initial_m[i];
    const float after_m = comparison.final_m[i];
    const float depth_m = after_m > 0.0F ? after_m : before_m;
    if (depth_m > 0.0F) depth.depths_m.push_back(depth_m);
    if (before_m > 0.0F && after_m > 0.0F) depth.heights_m.push_back(before_m - after_m);
    depth.lost += after_m > 0.0F ? 0 : 1;
  }
  return depth;
}

void place(const Intrinsics& camera, std::vector<float>& depths_m, Finding& finding) {
  if (depths_m.empty()) return;
  const double depth_m = quantile(depths_m, 0.5);
  finding.position_m = camera.deproject(finding.centroid, depth_m);
  finding.size_mm = {finding.box.width * depth_m / camera.fx * mm_per_m,
                     finding.box.height * depth_m / camera.fy * mm_per_m};
}

// By its height, where at least half of it has one; else by whether depth went or came.
void tell_kind(RegionDepth& depth, Finding& finding) {
  const std::size_t without_height = finding.pixels.size() - depth.heights_m.size();
  if (!depth.heights_m.empty() && depth.heights_m.size() >= without_height) {
    finding.height_mm = quantile(depth.heights_m, 0.5) * mm_per_m;
    finding.kind = *finding.height_mm < 0.0 ? ChangeKind::removed : ChangeKind::added;
  } else {
    finding.kind = 2 * depth.lost >= without_height ? ChangeKind::added : ChangeKind::removed;
  }
}

Finding measure(Region region, const Comparison& comparison, const Intrinsics& camera) {
  Finding finding;
  finding.box = region.box;
  finding.pixels = std::move(region.pixels);
  const auto width = static_cast<std::uint32_t>(comparison.changed.width());
  Eigen::Vector2d sum(0.0, 0.0);
  double evidence = 0.0;
  float rarest = std::numeric_limits<float>::lowest();
  for (const std::uint32_t i : finding.pixels) {
    sum += Eigen::Vector2d(i % width, i / width);
    evidence += comparison.evidence[i];
    rarest = std::max(rarest, comparison.evidence[i]);
  }
  const auto area = static_cast<double>(finding.pixels.size());
  finding.centroid = sum / area;
  RegionDepth depth = depth_of(finding.pixels, comparison);
  place(camera, depth.depths_m, finding);
  tell_kind(depth, finding);
  if (comparison.evidence_is_rarity) {
    finding.score = rarest;
    // None, if places are scattered by chance (Poisson).
    finding.p_value = -std::expm1(-std::pow(10.0, -static_cast<double>(rarest)));
  } else {
    finding.score = evidence / std::sqrt(area);
  }
  return finding;
}

}  // namespace

std::vector<Finding> measure_regions(std::vector<Region> regions, const Comparison& comparison,
                                     const Intrinsics& camera) {
  std::vector<Finding> findings;
  findings.reserve(regions.size());
  for (Region& region : regions) findings.push_back(measure(std::move(region), comparison, camera));
  std::ranges::stable_sort(findings, [](const Finding& a, const Finding& b) { return a.score > b.score; });
  int id = 0;
  for (Finding& finding : findings) finding.id = ++id;
  return findings;
}

}  // namespace rva
