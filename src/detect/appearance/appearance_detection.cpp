#include "detect/appearance/appearance_detection.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "core/quantile.hpp"
#include "core/stopwatch.hpp"
#include "core/units.hpp"
#include "depth/mat_view.hpp"
#include "detect/appearance/appearance_evidence.hpp"
#include "detect/appearance/color_evidence.hpp"
#include "detect/appearance/surface_level.hpp"
#include "detect/regions/regions.hpp"
#include "detect/spatial/joint_evidence.hpp"
#include "detect/spatial/still_evidence.hpp"
#include "geometry/stereo_scale.hpp"

namespace rva {
namespace {

constexpr std::size_t least_captures = 4;
constexpr std::size_t least_captures_without_dots = 2;
// Evidence above this many deviations supports a finding.
constexpr float speaks_deviations = 4.0F;
constexpr int least_pixels = 3;
// Largest distance of blobs that form one finding, such as a collar and its shadow in the light of the dots.
constexpr double join_px = 9.0;

std::size_t with_infrared(const Captures& side, Light light) {
  return static_cast<std::size_t>(std::ranges::count_if(
      side, [light](const auto& capture) { return capture->has_infrared(Imager::left, light); }));
}

bool has_right_images(const Captures& side) {
  return std::ranges::any_of(
      side, [](const auto& capture) { return capture->has_infrared(Imager::right, Light::projector); });
}

// The reason why images in this light are not compared, if only some captures have them; empty if all
// captures have them or none has.
std::string why_not_comparable(const Captures& initial, const Captures& final, Light light) {
  const std::size_t images = with_infrared(initial, light) + with_infrared(final, light);
  if (images == initial.size() + final.size()) return "";
  if (light == Light::lamp)
    return images > 0 ? "not every capture has images under the lamp: these were not compared" : "";
  if (images > 0) return "not every capture has infrared images: depth alone was compared";
  if (has_right_images(initial) || has_right_images(final))
    return "the captures have infrared images of the right imager alone: depth alone was compared";
  return "";
}

// Equation 26 of docs/math.md.
void add_significant(const JudgedChange& found, double false_findings, const Mask& left_out, Mask& mask) {
  const AppearanceChange& change = found.change;
  const auto least = static_cast<float>(found.tail.height_of(0.5 * false_findings));
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (change.judged[i] == 0 || is_left_out(left_out, i)) continue;
    if (std::abs(change.deviations[i]) > least) mask[i] = mask_set;
  }
}

// Score: -log10 of the expected number of locations with as much evidence by chance, in all lights together.
// Equation 27 of docs/math.md.
double score_of(const std::vector<std::uint32_t>& pixels, const std::vector<JudgedChange>& lights) {
  double score = -std::numeric_limits<double>::infinity();
  for (const JudgedChange& light : lights) {
    float strongest = 0.0F;
    for (const std::uint32_t i : pixels)
      strongest = std::max(strongest, std::abs(light.change.deviations[i]));
    score = std::max(score, -light.tail.log10_expected_above(static_cast<double>(strongest)));
  }
  constexpr double both_signs = 2.0;
  return score - std::log10(both_signs * static_cast<double>(lights.size()));
}

// The height is what the pairs measured in disparity, converted at the finding's depth after the work.
void give_height(float nearer_px, const StereoScale& stereo, Finding& finding) {
  if (!finding.position_m) return;
  const double after_px = stereo.disparity_px(finding.position_m->z());
  const double before_px = after_px - static_cast<double>(nearer_px);
  if (before_px > 0.0) finding.height_mm = mm_per_m * (stereo.depth_m(before_px) - finding.position_m->z());
}

// The depth images may not show what the pairs show. Depth with the object is that without it, changed by
// what the pairs measured.
void measure_by_pairs(const DepthView& view, const Detection& detection, Finding& finding) {
  if (detection.initial_m.empty() || finding.kind == ChangeKind::appearance || !finding.height_mm) return;
  const bool added = finding.kind == ChangeKind::added;
  const StereoScale& stereo = view.stereo;
  const double after_m = finding.position_m->z();
  const double nearer_px =
      stereo.disparity_px(after_m) - stereo.disparity_px(after_m + *finding.height_mm / mm_per_m);
  const Image<float>& without_m = added ? detection.initial_m : detection.final_m;
  Image<float> with_m = added ? detection.final_m : detection.initial_m;
  for (const std::uint32_t i : finding.pixels) {
    const auto without = static_cast<double>(without_m[i]);
    with_m[i] = without > 0.0
                    ? static_cast<float>(stereo.depth_m(stereo.disparity_px(without) + std::abs(nearer_px)))
                    : 0.0F;
  }
  measure_surroundings(added ? without_m : with_m, added ? with_m : without_m, detection.changed, view.camera,
                       finding);
}

/// The strongest evidence of one light over a finding, in deviations.
struct Strongest {
  float moved = 0.0F;      // motion of the surface, in either direction
  float all = 0.0F;        // appearance and surface together
  float nearer_px = 0.0F;  // median change of disparity
};

Strongest strongest_of(const JudgedChange& light, const std::vector<std::uint32_t>& pixels) {
  Strongest strongest;
  std::vector<float> nearer_px;
  for (const std::uint32_t i : pixels) {
    strongest.all = std::max(strongest.all, std::abs(light.change.deviations[i]));
    if (light.surface.judged[i] == 0) continue;
    strongest.moved = std::max(strongest.moved, std::abs(light.surface.deviations[i]));
    nearer_px.push_back(light.surface.nearer_px[i]);
  }
  if (!nearer_px.empty()) strongest.nearer_px = quantile(nearer_px, 0.5);
  return strongest;
}

// Sets kind and evidence of a finding. If the stereo pairs show by themselves that the surface moved, the
// kind is `added` or `removed`, else `appearance`. The median decides on the direction, since single pixels
// beside an object, which only one imager sees, may show either.
void name_evidence(const std::vector<JudgedChange>& lights, const StereoScale& stereo, Finding& finding) {
  constexpr float least_px = 0.05F;
  finding.kind = ChangeKind::appearance;
  finding.evidence = {.depth = false, .appearance = true};
  for (const JudgedChange& light : lights) {
    if (light.surface.judged.empty()) continue;
    const Strongest strongest = strongest_of(light, finding.pixels);
    if (strongest.moved < speaks_deviations || std::abs(strongest.nearer_px) < least_px) continue;
    const float seen =
        std::sqrt(std::max(std::pow(strongest.all, 2.0F) - std::pow(strongest.moved, 2.0F), 0.0F));
    finding.kind = strongest.nearer_px > 0.0F ? ChangeKind::added : ChangeKind::removed;
    finding.evidence = {.depth = true, .appearance = seen > speaks_deviations};
    give_height(strongest.nearer_px, stereo, finding);
  }
}

Finding finding_of(Region region, const std::vector<JudgedChange>& lights, const Image<float>& final_m,
                   const DepthView& view) {
  Finding finding;
  finding.box = region.box;
  finding.pixels = std::move(region.pixels);
  const auto width = static_cast<std::uint32_t>(final_m.width());
  Eigen::Vector2d sum(0.0, 0.0);
  std::vector<float> depths_m;
  for (const std::uint32_t i : finding.pixels) {
    sum += Eigen::Vector2d(i % width, i / width);
    if (final_m[i] > 0.0F) depths_m.push_back(final_m[i]);
  }
  finding.centroid = sum / static_cast<double>(finding.pixels.size());
  locate(view.camera, depths_m, finding);
  name_evidence(lights, view.stereo, finding);
  finding.score = score_of(finding.pixels, lights);
  finding.p_value = -std::expm1(-std::pow(10.0, -*finding.score));
  return finding;
}

Mask judged_in_any(const std::vector<JudgedChange>& lights) {
  Mask judged = lights.front().change.judged;
  for (const JudgedChange& light : lights) {
    for (std::size_t i = 0; i < judged.size(); ++i) judged[i] |= light.change.judged[i];
  }
  return judged;
}

void add_changes(ImageChanges images, InfraredCompared compared, double false_findings,
                 const RegionOptions& regions, const DepthView& final_view, Detection& detection) {
  std::vector<JudgedChange>& changes = images.infrared;
  const std::optional<Mask> judged_in_infrared =
      changes.empty() ? std::nullopt : std::optional(judged_in_any(changes));
  if (images.color) changes.push_back(std::move(*images.color));
  const Mask judged = judged_in_any(changes);
  Mask mask(judged.width(), judged.height());
  const double of_each_light = false_findings / static_cast<double>(changes.size());
  for (const JudgedChange& change : changes) add_significant(change, of_each_light, detection.left_out, mask);
  std::vector<Finding>& findings = detection.findings.findings;
  give_evidence(mask, findings);
  // Colour images do not refute a finding of depth: an object may have the colour of its background.
  if (judged_in_infrared)
    drop_unsupported({*judged_in_infrared, compared, final_view.stereo}, false_findings, detection);
  for (Region& region : find_regions(mask, {.min_blob_px = std::max(least_pixels, regions.min_blob_px),
                                           .join_px = std::min(join_px, regions.join_px)})) {
    Finding finding = finding_of(std::move(region), changes, detection.final_m, final_view);
    if (is_spike_of_surfaces(finding, final_view.camera.fx)) continue;
    for (const std::uint32_t i : finding.pixels) detection.changed[i] = mask_set;
    measure_by_pairs(final_view, detection, finding);
    finding.id = static_cast<int>(findings.size()) + 1;
    findings.push_back(std::move(finding));
  }
  order(findings);
  const auto pixels = std::ranges::count(judged.pixels(), mask_set);
  detection.findings.appearance_judged = static_cast<double>(pixels) / static_cast<double>(judged.size());
}

void add_time(const Stopwatch& start, Detection& detection) {
  detection.findings.runtime.detect_ms += start.ms();
  detection.findings.runtime.total_ms += start.ms();
}

}  // namespace

ComparedImages comparable_images(const Captures& initial, const Captures& final,
                                 std::vector<std::string>& warnings) {
  ComparedImages images;
  const std::size_t fewest = std::min(initial.size(), final.size());
  for (const Light light : {Light::projector, Light::lamp}) {
    if (std::string reason = why_not_comparable(initial, final, light); !reason.empty())
      warnings.push_back(std::move(reason));
    else if (with_infrared(initial, light) > 0 &&
             fewest >= (light == Light::projector ? least_captures : least_captures_without_dots))
      images.lights.push_back(light);
  }
  images.color = fewest >= least_captures_without_dots && have_lit_color(initial, final);
  return images;
}

void add_appearance(const Captures& initial, const Captures& final, const ComparedImages& images,
                    const PlacedCaptures& placed, double false_findings, const RegionOptions& regions,
                    Detection& detection) {
  const Stopwatch start;
  const Transform initial_from_final = detection.findings.final_from_initial.inverse();
  if (placed.final_view.disparity_px.empty()) {
    detection.warnings.emplace_back(
        "lens distortion is not supported here: infrared images were not compared");
    return;
  }
  if (!came_back_nearly(initial_from_final)) return;
  ImageChanges changes;
  for (const Light light : images.lights) {
    if (auto change = change_between(initial, final, placed, initial_from_final, light, detection.warnings))
      changes.infrared.push_back(std::move(*change));
  }
  if (images.color)
    changes.color = color_change_between(initial, final, placed, initial_from_final, detection.warnings);
  if (!changes.any()) return;
  const bool surfaces = std::ranges::any_of(
      changes.infrared, [](const JudgedChange& change) { return !change.surface.judged.empty(); });
  const auto lights = static_cast<double>(changes.infrared.size() + (changes.color ? 1 : 0));
  for (const JudgedChange& change : changes.infrared)
    lower_level_of_detection(change, false_findings / lights, placed.final_view.stereo, detection);
  add_changes(std::move(changes), surfaces ? InfraredCompared::surfaces : InfraredCompared::appearance,
              false_findings, regions, placed.final_view, detection);
  add_time(start, detection);
}

ComparedImages still_images(const Captures& initial, const Captures& final) {
  ComparedImages images;
  if (final.front()->info().depth.distortion != Distortion::none) return images;
  for (const Light light : {Light::projector, Light::lamp}) {
    if (initial.front()->has_infrared(Imager::left, light) &&
        final.front()->has_infrared(Imager::left, light))
      images.lights.push_back(light);
  }
  images.color = have_lit_color(initial, final);
  return images;
}

ImageChanges still_changes(const Capture& initial, const Capture& final, const ComparedImages& images,
                           const DepthView& final_view, std::vector<std::string>& warnings) {
  ImageChanges changes;
  for (const Light light : images.lights) {
    if (auto change = still_change_between(initial, final, final_view, light, warnings))
      changes.infrared.push_back(std::move(*change));
  }
  if (images.color) changes.color = still_color_change_between(initial, final, final_view, warnings);
  return changes;
}

void add_still_appearance(ImageChanges changes, const DepthView& final_view, double false_findings,
                          const RegionOptions& regions, Detection& detection) {
  const Stopwatch start;
  add_changes(std::move(changes), InfraredCompared::still, false_findings, regions, final_view, detection);
  add_time(start, detection);
}

}  // namespace rva
