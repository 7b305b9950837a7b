#include "detect/spatial/joint_evidence.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <opencv2/imgproc.hpp>
#include <optional>
#include <utility>

#include "core/units.hpp"
#include "depth/mat_view.hpp"
#include "detect/regions/regions.hpp"

namespace rva {
namespace {

/// For each pixel in or beside a finding of depth, the index of the finding plus one; else 0.
Image<std::uint16_t> owners(const std::vector<Finding>& findings, int width, int height) {
  constexpr int beside_px = 4;
  Image<std::uint16_t> owner(width, height);
  for (std::size_t k = 0; k < findings.size(); ++k) {
    for (const std::uint32_t i : findings[k].pixels) owner[i] = static_cast<std::uint16_t>(k + 1);
  }
  cv::Mat pixels = as_mat(owner);
  cv::dilate(pixels, pixels, cv::Mat::ones(2 * beside_px + 1, 2 * beside_px + 1, CV_8U));
  return owner;
}

// By how much rarer than allowed a finding of depth must be to be kept without evidence from infrared images.
// Infrared images respond to nearly all changes of depth: with eight captures, to all but one of 64 findings
// of debris in development (docs/infrared.md). The factor is much larger where the stereo pairs were compared
// as well, which measure the same as depth, or every pixel of a camera that stood still, since depth is
// computed from those images.
double unsupported_factor(InfraredCompared compared) {
  return compared == InfraredCompared::appearance ? 50.0 : 1e4;
}

// True also for depth that appeared or went missing.
bool moved_by_a_pixel(const Finding& finding, const StereoScale& stereo) {
  if (!finding.height_mm || !finding.position_m) return true;
  const double after_m = finding.position_m->z();
  const double before_m = after_m + m_per_mm * *finding.height_mm;
  return before_m <= 0.0 || std::abs(stereo.disparity_px(after_m) - stereo.disparity_px(before_m)) >= 1.0;
}

bool is_unsupported(const Finding& finding, const InfraredComparison& infrared, double least_score) {
  if (finding.evidence.appearance || !finding.score) return false;
  const auto judged =
      std::ranges::count_if(finding.pixels, [&](std::uint32_t i) { return infrared.judged[i] != 0; });
  if (2 * static_cast<std::size_t>(judged) <= finding.pixels.size()) return false;
  return *finding.score < least_score ||
         (infrared.compared == InfraredCompared::still && moved_by_a_pixel(finding, infrared.stereo));
}

// Numbers findings in their order from 1, and updates their references to each other.
void number(std::vector<Finding>& findings) {
  std::map<int, int> now_from_before;
  for (Finding& finding : findings) {
    const int now = static_cast<int>(now_from_before.size()) + 1;
    now_from_before.emplace(finding.id, now);
    finding.id = now;
  }
  for (Finding& finding : findings) {
    if (!finding.moved_from) continue;
    const auto found = now_from_before.find(*finding.moved_from);
    finding.moved_from = found == now_from_before.end() ? std::nullopt : std::optional(found->second);
  }
}

}  // namespace

void give_evidence(Mask& mask, std::vector<Finding>& findings) {
  const Image<std::uint16_t> owner = owners(findings, mask.width(), mask.height());
  for (const Region& blob : find_regions(mask, {.min_blob_px = 0, .join_px = 0.0})) {
    const auto touched = std::ranges::find_if(blob.pixels, [&](std::uint32_t i) { return owner[i] > 0; });
    if (touched == blob.pixels.end()) continue;
    findings[owner[*touched] - 1U].evidence.appearance = true;
    for (const std::uint32_t i : blob.pixels) mask[i] = 0;
  }
}

void order(std::vector<Finding>& findings) {
  std::ranges::stable_sort(findings, [](const Finding& a, const Finding& b) {
    return std::pair(a.evidence.depth, a.score.value_or(0.0)) >
           std::pair(b.evidence.depth, b.score.value_or(0.0));
  });
  number(findings);
}

bool is_spike_of_surfaces(const Finding& finding, double focal_px) {
  constexpr double most_height_per_width = 3.0;
  if (finding.evidence.appearance || !finding.height_mm || !finding.position_m) return false;
  const double width_px = std::sqrt(static_cast<double>(finding.pixels.size()));
  const double width_mm = mm_per_m * width_px * finding.position_m->z() / focal_px;
  return std::abs(*finding.height_mm) > most_height_per_width * width_mm;
}

void drop_unsupported(const InfraredComparison& infrared, double false_findings, Detection& detection) {
  const double least_score = std::log10(unsupported_factor(infrared.compared) / false_findings);
  std::vector<Finding>& findings = detection.findings.findings;
  std::erase_if(findings, [&](const Finding& finding) {
    if (!is_unsupported(finding, infrared, least_score)) return false;
    for (const std::uint32_t i : finding.pixels) detection.changed[i] = 0;
    return true;
  });
  number(findings);
}

}  // namespace rva
