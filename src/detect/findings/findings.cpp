#include "detect/findings/findings.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/quantile.hpp"
#include "core/units.hpp"
#include "detect/findings/height_above_surroundings.hpp"
#include "detect/findings/moved_things.hpp"

namespace rva {
namespace {

/// Valid depths over a region.
struct RegionDepth {
  std::vector<float> depths_m;   // after, or before where there is none after
  std::vector<float> heights_m;  // decrease of depth, where measured both before and after
};

RegionDepth depth_of(const std::vector<std::uint32_t>& pixels, const Comparison& comparison) {
  RegionDepth depth;
  for (const std::uint32_t i : pixels) {
    const float before_m = comparison.initial_m[i];
    const float after_m = comparison.final_m[i];
    const float depth_m = after_m > 0.0F ? after_m : before_m;
    if (depth_m > 0.0F) depth.depths_m.push_back(depth_m);
    if (before_m > 0.0F && after_m > 0.0F) depth.heights_m.push_back(before_m - after_m);
  }
  return depth;
}

// Returns the median height, or nothing if its sign contradicts the kind: where depth went missing on a shiny
// object, the depth that remains may belong to any surface.
std::optional<double> height_mm(RegionDepth& depth, std::size_t pixels, ChangeKind kind) {
  if (depth.heights_m.empty() || 2 * depth.heights_m.size() < pixels) return std::nullopt;
  const double height_mm = quantile(depth.heights_m, 0.5) * mm_per_m;
  const bool agrees = kind == ChangeKind::added ? height_mm > 0.0 : height_mm < 0.0;
  return agrees ? std::optional(height_mm) : std::nullopt;
}

// Equation 27 of docs/math.md.
Finding measure(Region region, ChangeKind kind, const Comparison& comparison, const Intrinsics& camera) {
  Finding finding;
  finding.kind = kind;
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
  locate(camera, depth.depths_m, finding);
  finding.height_mm = height_mm(depth, finding.pixels.size(), kind);
  measure_surroundings(comparison.initial_m, comparison.final_m, comparison.changed, camera, finding);
  if (comparison.evidence_is_rarity) {
    finding.score = rarest;
    // By Poisson statistics: 1 - exp(-n), where n = 10^-rarest is the expected number of such locations.
    finding.p_value = -std::expm1(-std::pow(10.0, -static_cast<double>(rarest)));
  } else {
    finding.score = evidence / std::sqrt(area);
  }
  return finding;
}

Mask changed_to(ChangeKind kind, const Comparison& comparison) {
  Mask mask(comparison.changed.width(), comparison.changed.height());
  const bool farther = kind == ChangeKind::removed;
  for (std::size_t i = 0; i < mask.size(); ++i) {
    const bool of_kind = comparison.changed[i] != 0 && (comparison.farther[i] != 0) == farther;
    mask[i] = of_kind ? mask_set : std::uint8_t{0};
  }
  return mask;
}

}  // namespace

void locate(const Intrinsics& camera, std::vector<float>& depths_m, Finding& finding) {
  if (depths_m.empty()) return;
  const double depth_m = quantile(depths_m, 0.5);
  finding.position_m = camera.deproject(finding.centroid, depth_m);
  finding.size_mm = {finding.box.width * depth_m / camera.fx * mm_per_m,
                     finding.box.height * depth_m / camera.fy * mm_per_m};
}

// An object that was added is seen after, one that was removed is seen before.
void measure_surroundings(const Image<float>& initial_m, const Image<float>& final_m, const Mask& changed,
                          const Intrinsics& camera, Finding& finding) {
  const BeforeAndAfter depth = finding.kind == ChangeKind::added ? BeforeAndAfter{final_m, initial_m}
                                                                 : BeforeAndAfter{initial_m, final_m};
  const auto height = height_above_surroundings(finding.pixels, depth, changed, camera);
  if (!height) return;
  finding.above_surroundings_mm = height->median_mm;
  finding.top_above_surroundings_mm = height->top_mm;
  finding.top_is_least = height->at_least;
  finding.background_jump =
      finding.height_mm && is_background_jump(std::abs(*finding.height_mm), height->median_mm);
}

std::vector<Finding> find_findings(const Comparison& comparison, const RegionOptions& options,
                                   const Intrinsics& camera) {
  std::vector<Finding> findings;
  for (const ChangeKind kind : {ChangeKind::added, ChangeKind::removed}) {
    for (Region& region : find_regions(changed_to(kind, comparison), options))
      findings.push_back(measure(std::move(region), kind, comparison, camera));
  }
  std::ranges::stable_sort(findings, [](const Finding& a, const Finding& b) { return a.score > b.score; });
  int id = 0;
  for (Finding& finding : findings) finding.id = ++id;
  find_moved_things(findings, comparison, camera);
  return findings;
}

}  // namespace rva
