#include "cloud/appearance_detection.hpp"

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <utility>

#include "cloud/appearance_evidence.hpp"
#include "cloud/joint_evidence.hpp"
#include "core/stopwatch.hpp"
#include "depth/mat_view.hpp"
#include "detect/regions.hpp"

namespace rva {
namespace {

constexpr std::size_t least_captures = 4;
// Stains and reflections change so much; a collar changes more.
constexpr float least_contrast = 0.015F;
constexpr int least_pixels = 3;
// Blobs of one thing: a collar, and its shadow in what the dots light up.
constexpr double join_px = 9.0;

std::size_t with_infrared(const Captures& side) {
  return static_cast<std::size_t>(
      std::ranges::count_if(side, [](const auto& capture) { return capture->has_infrared(); }));
}

Mask significant(const AppearanceChange& change, const FalseAlarmTail& tail, double false_findings,
                 const Mask& left_out) {
  const auto least = static_cast<float>(tail.height_of(0.5 * false_findings));
  Mask mask(change.judged.width(), change.judged.height());
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (change.judged[i] == 0 || is_left_out(left_out, i)) continue;
    if (std::abs(change.deviations[i]) > least && std::abs(change.contrast[i]) > least_contrast)
      mask[i] = mask_set;
  }
  return mask;
}

Finding finding_of(Region region, const AppearanceChange& change, const FalseAlarmTail& tail,
                   const Image<float>& final_m, const Intrinsics& camera) {
  Finding finding;
  finding.kind = ChangeKind::appearance;
  finding.evidence = {.depth = false, .appearance = true};
  finding.box = region.box;
  finding.pixels = std::move(region.pixels);
  const auto width = static_cast<std::uint32_t>(final_m.width());
  Eigen::Vector2d sum(0.0, 0.0);
  float strongest = 0.0F;
  std::vector<float> depths_m;
  for (const std::uint32_t i : finding.pixels) {
    sum += Eigen::Vector2d(i % width, i / width);
    strongest = std::max(strongest, std::abs(change.deviations[i]));
    if (final_m[i] > 0.0F) depths_m.push_back(final_m[i]);
  }
  finding.centroid = sum / static_cast<double>(finding.pixels.size());
  place(camera, depths_m, finding);
  constexpr double both_signs = 2.0;
  finding.score = -std::log10(both_signs) - tail.log10_expected_above(static_cast<double>(strongest));
  finding.p_value = -std::expm1(-std::pow(10.0, -*finding.score));
  return finding;
}

}  // namespace

bool have_infrared(const Captures& initial, const Captures& final, std::vector<std::string>& warnings) {
  const std::size_t before = with_infrared(initial);
  const std::size_t after = with_infrared(final);
  if (before == initial.size() && after == final.size()) return std::min(before, after) >= least_captures;
  if (before + after > 0)
    warnings.emplace_back("not every capture has infrared images: depth alone was compared");
  return false;
}

void add_appearance(const Captures& initial, const Captures& final, const PlacedCaptures& placed,
                    double false_findings, const RegionOptions& regions, Detection& detection) {
  const Stopwatch start;
  const Transform initial_from_final = detection.findings.final_from_initial.inverse();
  if (placed.final_view.disparity_px.empty() || !came_back_nearly(initial_from_final)) return;
  const std::optional<JudgedChange> found = change_between(initial, final, placed, initial_from_final);
  if (!found) {
    detection.warnings.emplace_back(
        "the infrared images could not be laid over each other: depth alone was compared");
    return;
  }
  const auto& [change, tail] = *found;
  Mask mask = significant(change, tail, false_findings, detection.left_out);
  std::vector<Finding>& findings = detection.findings.findings;
  give_evidence(mask, findings);
  drop_unsupported(change, false_findings, detection);
  std::vector<Finding> others;
  for (Region& region : find_regions(mask, {.min_blob_px = std::max(least_pixels, regions.min_blob_px),
                                           .join_px = std::min(join_px, regions.join_px)})) {
    for (const std::uint32_t i : region.pixels) detection.changed[i] = mask_set;
    others.push_back(
        finding_of(std::move(region), change, tail, detection.final_m, placed.final_view.camera));
  }
  std::ranges::stable_sort(others, [](const Finding& a, const Finding& b) { return a.score > b.score; });
  for (Finding& finding : others) {
    finding.id = static_cast<int>(findings.size()) + 1;
    findings.push_back(std::move(finding));
  }
  const auto judged = std::ranges::count(change.judged.pixels(), mask_set);
  detection.findings.appearance_judged =
      static_cast<double>(judged) / static_cast<double>(change.judged.size());
  detection.findings.runtime.detect_ms += start.ms();
  detection.findings.runtime.total_ms += start.ms();
}

}  // namespace rva
