#include "detect/findings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/quantile.hpp"

namespace rva {
namespace {

constexpr double mm_per_m = 1000.0;

Finding measure(Region region, const Comparison& comparison, const Intrinsics& camera) {
  Finding finding;
  finding.box = region.box;
  finding.pixels = std::move(region.pixels);
  const auto width = static_cast<std::uint32_t>(comparison.changed.width());
  std::vector<float> depths_m;
  std::vector<float> heights_m;
  Eigen::Vector2d sum(0.0, 0.0);
  double evidence = 0.0;
  float rarest = std::numeric_limits<float>::lowest();
  for (const std::uint32_t i : finding.pixels) {
    sum += Eigen::Vector2d(i % width, i / width);
    evidence += comparison.evidence[i];
    rarest = std::max(rarest, comparison.evidence[i]);
    depths_m.push_back(comparison.final_m[i]);
    heights_m.push_back(comparison.initial_m[i] - comparison.final_m[i]);
  }
  const auto area = static_cast<double>(finding.pixels.size());
  const double depth_m = quantile(depths_m, 0.5);
  finding.centroid = sum / area;
  finding.position_m = camera.deproject(finding.centroid, depth_m);
  finding.size_mm = {finding.box.width * depth_m / camera.fx * mm_per_m,
                     finding.box.height * depth_m / camera.fy * mm_per_m};
  finding.height_mm = quantile(heights_m, 0.5) * mm_per_m;
  finding.kind = *finding.height_mm < 0.0 ? ChangeKind::removed : ChangeKind::added;
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
