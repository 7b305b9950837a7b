#include "detect/findings/loose_parts.hpp"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <string_view>
#include <tuple>

#include "core/units.hpp"

namespace rva {
namespace {

// Crescents of one part differ by their light and shadow, and by what the matcher makes of their edges: on
// development seeds, areas by up to a factor of 2.5 and heights by up to a third.
constexpr double most_area_ratio = 2.5;
constexpr double outline_px = 1.5;  // by which an outline is uncertain
constexpr double height_share = 0.5;
constexpr double height_noise_mm = 3.0;

bool have_like_areas(const Finding& a, const Finding& b) {
  const auto a_px = static_cast<double>(a.pixels.size());
  const auto b_px = static_cast<double>(b.pixels.size());
  const double greater_px = std::max(a_px, b_px);
  return greater_px <= most_area_ratio * std::min(a_px, b_px) + 4.0 * std::sqrt(greater_px) * outline_px;
}

bool have_like_heights(const Finding& a, const Finding& b) {
  if (!a.height_mm || !b.height_mm) return true;
  const double a_mm = std::abs(*a.height_mm);
  const double b_mm = std::abs(*b.height_mm);
  return std::abs(a_mm - b_mm) <= height_share * std::max(a_mm, b_mm) + height_noise_mm;
}

// Median distance of the part: after where it is and before where it was.
std::optional<double> distance_m_of(const Finding& added, const Finding& removed,
                                    const Detection& detection) {
  std::vector<double> depths_m;
  const auto add = [&](const Finding& finding, const Image<float>& depth_m) {
    for (const std::uint32_t i : finding.pixels) {
      if (depth_m[i] > 0.0F) depths_m.push_back(static_cast<double>(depth_m[i]));
    }
  };
  add(added, detection.final_m);
  add(removed, detection.initial_m);
  if (depths_m.empty()) return std::nullopt;
  // The mean of the two middle values, so that an exchange of the captures changes nothing.
  std::ranges::sort(depths_m);
  const std::size_t count = depths_m.size();
  return 0.5 * (depths_m[(count - 1) / 2] + depths_m[count / 2]);
}

std::optional<LoosePart> part_of(const Finding& added, const Finding& removed, const Detection& detection,
                                 const Intrinsics& camera, double reach_mm) {
  if (!have_like_areas(added, removed) || !have_like_heights(added, removed)) return std::nullopt;
  const std::optional<double> distance_m = distance_m_of(added, removed, detection);
  if (!distance_m) return std::nullopt;
  const Eigen::Vector2d mm_per_px(mm_per_m * *distance_m / camera.fx, mm_per_m * *distance_m / camera.fy);
  const Box& a = added.box;
  const Box& b = removed.box;
  const Eigen::Vector2d extent_px(std::max(a.x + a.width, b.x + b.width) - std::min(a.x, b.x),
                                  std::max(a.y + a.height, b.y + b.height) - std::min(a.y, b.y));
  const Eigen::Vector2d size_mm = extent_px.cwiseProduct(mm_per_px);
  const LoosePart part{.added = added.id,
                       .removed = removed.id,
                       .apart_mm = (added.centroid - removed.centroid).cwiseProduct(mm_per_px),
                       .size_mm = {size_mm.x(), size_mm.y()}};
  return part.moved_at_most_mm() <= reach_mm ? std::optional(part) : std::nullopt;
}

}  // namespace

std::vector<LoosePart> find_loose_parts(const Detection& detection, const Intrinsics& camera,
                                        const LoosePartOptions& options) {
  check_options(options);
  std::vector<LoosePart> candidates;
  for (const Finding& added : detection.findings.findings) {
    if (added.kind != ChangeKind::added) continue;
    for (const Finding& removed : detection.findings.findings) {
      if (removed.kind != ChangeKind::removed) continue;
      if (const auto part = part_of(added, removed, detection, camera, options.reach_mm))
        candidates.push_back(*part);
    }
  }
  std::ranges::sort(candidates, {}, [](const LoosePart& part) {
    return std::tuple(part.moved_at_most_mm(), part.added, part.removed);
  });
  std::vector<LoosePart> parts;
  std::set<int> taken;
  for (const LoosePart& candidate : candidates) {
    if (taken.contains(candidate.added) || taken.contains(candidate.removed)) continue;
    taken.insert({candidate.added, candidate.removed});
    parts.push_back(candidate);
  }
  return parts;
}

std::string direction_of(const LoosePart& part) {
  struct Axis {
    std::string_view negative;
    std::string_view positive;
  };
  static constexpr std::array axes{Axis{"to the left", "to the right"}, Axis{"up", "down"}};
  constexpr double noticeable = 0.4;  // of the whole motion
  std::string words;
  for (std::size_t axis = 0; axis < axes.size(); ++axis) {
    const double along_mm = part.apart_mm[static_cast<Eigen::Index>(axis)];
    if (std::abs(along_mm) < noticeable * part.moved_at_most_mm()) continue;
    if (!words.empty()) words += " and ";
    words += along_mm < 0.0 ? axes.at(axis).negative : axes.at(axis).positive;
  }
  return words;
}

void add_loose_parts(const std::vector<LoosePart>& parts, nlohmann::ordered_json& detections) {
  nlohmann::ordered_json& list = detections["loose_parts"] = nlohmann::ordered_json::array();
  int id = 0;
  for (const LoosePart& part : parts) {
    list.push_back({{"id", ++id},
                    {"added", part.added},
                    {"removed", part.removed},
                    {"moved_at_most_mm", part.moved_at_most_mm()},
                    {"apart_mm", {part.apart_mm.x(), part.apart_mm.y()}},
                    {"direction", direction_of(part)},
                    {"size_mm", part.size_mm}});
    for (nlohmann::ordered_json& finding : detections["detections"]) {
      if (finding["id"] == part.added || finding["id"] == part.removed) finding["loose_part"] = id;
    }
  }
}

}  // namespace rva
