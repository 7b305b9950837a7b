#include "detect/spatial/spatial_detection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "capture/capture_view.hpp"
#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/parallel.hpp"
#include "core/stopwatch.hpp"
#include "detect/regions/left_out.hpp"
#include "detect/spatial/spatial_comparison.hpp"
#include "detect/spatial/surface_support.hpp"
#include "geometry/rigid_motion.hpp"
#include "geometry/stereo_scale.hpp"
#include "views/fused_view.hpp"
#include "views/view_check.hpp"

namespace rva {
namespace {

// The pose of one capture in the frame of the other, according to their stated poses; empty if those have no
// common base.
std::optional<Transform> known_transform(const CaptureInfo& to, const CaptureInfo& from) {
  if (!to.pose || !from.pose || !to.pose->base || to.pose->base != from.pose->base) return std::nullopt;
  if (!to.pose->world_from_camera || !from.pose->world_from_camera) return std::nullopt;
  return to.pose->world_from_camera->inverse() * *from.pose->world_from_camera;
}

// For each final capture, the index of the initial one with the same pose; empty if one of them has none.
std::vector<std::size_t> exact_returns(const Captures& initial, const Captures& final) {
  std::vector<std::size_t> returns;
  for (const auto& capture : final) {
    const auto same = std::ranges::find_if(initial, [&](const auto& candidate) {
      return known_transform(candidate->info(), capture->info()) &&
             candidate->info().depth == capture->info().depth &&
             is_same_unit(candidate->info().depth_unit_m, capture->info().depth_unit_m) &&
             !poses_differ(candidate->info(), capture->info());
    });
    if (same == initial.end()) return {};
    returns.push_back(static_cast<std::size_t>(same - initial.begin()));
  }
  return returns;
}

struct Compared {
  CalibratedComparison calibrated;
  Registration registration;
};

/// A capture with the statistics of its frames.
struct Seen {
  const CaptureInfo& info;
  DepthStatistics statistics;
  bool marks_no_depth_by_zero = true;

  [[nodiscard]] DepthView view() const { return depth_view(statistics, info.depth, stereo_scale(info)); }
};

class Run {
 public:
  Run(const SpatialDetectionOptions& options, const Progress& progress, const Mask& left_out)
      : options_(options), progress_(progress), left_out_(left_out) {
    check_options(options);
  }

  SpatialDetection run(const Captures& initial, const Captures& final) {
    const Stopwatch start;
    fewest_captures_ = std::min(initial.size(), final.size());
    const std::vector<Seen> before = read(initial, "initial", findings().initial_frames);
    const std::vector<Seen> after = read(final, "final", findings().final_frames);
    const std::vector<std::size_t> returns = exact_returns(initial, final);
    throw_if_interrupted();
    const Stopwatch detect_start;
    auto [calibrated, registration] = !returns.empty() && are_aligned(before, after, returns)
                                          ? from_the_same_poses(before, after, returns)
                                          : from_elsewhere(before, after);
    Comparison& comparison = calibrated.comparison;
    if (leans_on_pairs(registration.initial_from_final))
      keep_supported(initial, final, placed_, registration.initial_from_final,
                     options_.calibrated.false_findings, comparison);
    findings().runtime.detect_ms = detect_start.ms();
    const Stopwatch regions_start;
    findings().findings = find_findings(comparison, options_.regions, after.front().info.depth);
    findings().runtime.regions_ms = regions_start.ms();
    findings().runtime.total_ms = start.ms();
    throw_if_interrupted();
    warn_of_blindness(comparison,
                      "noise at edges and at large distances is too high there (more captures a side, one or "
                      "a few servo steps apart, help)",
                      detection_.warnings);
    findings().method = "spatial";
    findings().coverage = comparison.coverage;
    findings().final_from_initial = registration.initial_from_final.inverse();
    state(options_.calibrated, findings().parameters);
    state(options_.regions, findings().parameters);
    detection_.level_of_detection =
        LevelOfDetection{std::move(calibrated.level_of_detection_mm), std::move(calibrated.levels)};
    detection_.changed = std::move(comparison.changed);
    detection_.initial_m = std::move(comparison.initial_m);
    detection_.final_m = std::move(comparison.final_m);
    return {std::move(detection_), std::move(registration), std::move(placed_)};
  }

 private:
  Findings& findings() { return detection_.findings; }

  std::vector<Seen> read(const Captures& captures, std::string_view side, std::size_t& frames) {
    assert(!captures.empty());
    std::vector<Seen> seen;
    for (const auto& capture : captures) {
      const std::size_t used = frames_to_use(*capture, options_.use.frames, side, detection_.warnings);
      frames += used;
      seen.push_back({capture->info(), rva::statistics_of(*capture, used, progress_, findings().runtime),
                      capture->marks_no_depth_by_zero()});
    }
    return seen;
  }

  // Checks exact returns in the images, since servos that report the same step may be up to half a
  // step apart.
  bool are_aligned(const std::vector<Seen>& before, const std::vector<Seen>& after,
                   const std::vector<std::size_t>& returns) {
    for (std::size_t k = 0; k < after.size(); ++k) {
      if (after[k].info.depth.distortion != Distortion::none) continue;
      const ViewCheck check = check_views(before[returns[k]].view(), after[k].view());
      if (check.is_aligned()) continue;
      detection_.warnings.push_back(fmt::format(
          "captures whose poses are stated as equal show views {:.2g} pixels apart: they were registered "
          "instead of being compared pixel by pixel",
          std::max(check.motion.displacement_px, check.registered_px)));
      return false;
    }
    return true;
  }

  Compared from_elsewhere(const std::vector<Seen>& initial, const std::vector<Seen>& final) {
    DepthView before;
    DepthView after;
    constexpr int sides = 2;
    parallel_bands(sides, [&](int first, int end) {
      for (int side = first; side < end; ++side) {
        if (side == 0)
          before = fused(initial, "initial", placed_.first_from_initial);
        else
          after = fused(final, "final", placed_.first_from_final);
      }
    });
    throw_if_interrupted();
    Registration registration = registration_of(before, after, initial.front().info, final.front().info);
    SpatialChange change = change_from_elsewhere(before, after, registration, options_.known);
    leave_out_regions(initial, final, change, registration.initial_from_final);
    placed_.final_view = after;
    CalibratedComparison calibrated = compare_spatial(change, allowed(registration.initial_from_final));
    return {std::move(calibrated), std::move(registration)};
  }

  // After an exact return, the errors of the matcher cancel pixel by pixel.
  Compared from_the_same_poses(const std::vector<Seen>& initial, const std::vector<Seen>& final,
                               const std::vector<std::size_t>& returns) {
    const CaptureInfo& first = final.front().info;
    const StereoScale stereo = stereo_scale(first);
    // With lens distortion, poses cannot be checked: planes in space are not planes in disparity.
    const std::optional<DepthView> first_view =
        first.depth.distortion == Distortion::none ? std::optional(final.front().view()) : std::nullopt;
    const auto placed = [&](const Seen& seen) {
      return first_view ? transform_to_first(*first_view, seen.view(), first, seen.info, "final")
                        : known_transform(first, seen.info).value_or(Transform::Identity());
    };
    std::vector<PlacedChange> changes;
    for (std::size_t k = 0; k < final.size(); ++k) {
      const Seen& before = initial[returns[k]];
      placed_.first_from_final.push_back(k == 0 ? Transform::Identity() : placed(final[k]));
      changes.push_back({disparity_change(before.statistics, final[k].statistics, stereo),
                         placed_.first_from_final.back()});
      if (!before.marks_no_depth_by_zero || !final[k].marks_no_depth_by_zero)
        forget_losses(changes.back().change);
    }
    for (const Seen& seen : initial)
      placed_.first_from_initial.push_back(
          known_transform(initial.front().info, seen.info).value_or(Transform::Identity()));
    if (first_view) placed_.final_view = *first_view;
    Registration registration;
    registration.agreeing = registration.overlap = 1.0;
    registration.initial_from_final =
        known_transform(initial.front().info, first).value_or(Transform::Identity());
    SpatialChange change = change_from_same_places(std::move(changes), first.depth, stereo);
    leave_out_regions(initial, final, change, registration.initial_from_final);
    CalibratedComparison calibrated = compare_spatial(change, allowed(registration.initial_from_final));
    return {std::move(calibrated), std::move(registration)};
  }

  // Transfers the regions left out by the user to the final view.
  void leave_out_regions(const std::vector<Seen>& initial, const std::vector<Seen>& final,
                         SpatialChange& change, const Transform& initial_from_final) {
    if (left_out_.empty()) return;
    Image<float> final_m = change.change.after_px;
    for (float& value : final_m.pixels())
      value = value > 0.0F ? static_cast<float>(change.stereo.focal_baseline_m_px) / value : 0.0F;
    detection_.left_out = carry_over(left_out_, initial.front().info.depth, final.front().info.depth, final_m,
                                     initial_from_final);
    leave_out(change.change, detection_.left_out);
  }

  [[nodiscard]] CalibratedOptions allowed(const Transform& initial_from_final) const {
    CalibratedOptions options = options_.calibrated;
    if (leans_on_pairs(initial_from_final))
      options.false_findings *= rarity_of_support(fewest_captures_, initial_from_final);
    else if (came_back_nearly(initial_from_final))
      options.false_findings *= options_.share;
    return options;
  }

  [[nodiscard]] bool leans_on_pairs(const Transform& initial_from_final) const {
    const bool images_take_a_share = options_.share < 1.0 && came_back_nearly(initial_from_final);
    return options_.pairs && !images_take_a_share && !placed_.final_view.disparity_px.empty();
  }

  // Fuses all captures of a side into one view, in the camera of the first one.
  [[nodiscard]] static DepthView fused(const std::vector<Seen>& side, std::string_view name,
                                       std::vector<Transform>& first_from_view_of) {
    std::vector<PlacedView> views;
    for (std::size_t k = 0; k < side.size(); ++k) {
      DepthView view = side[k].view();
      const Transform first_from_view =
          k == 0 ? Transform::Identity()
                 : transform_to_first(views.front().view, view, side.front().info, side[k].info, name);
      first_from_view_of.push_back(first_from_view);
      views.push_back({std::move(view), first_from_view});
    }
    return fuse(views);
  }

  // The pose of a capture in the frame of the side's first capture.
  [[nodiscard]] static Transform transform_to_first(const DepthView& first, const DepthView& view,
                                                    const CaptureInfo& first_info, const CaptureInfo& info,
                                                    std::string_view name) {
    // About the effect of a twentieth of a degree, and twice the error of the registration itself.
    constexpr double contradicted_px = 0.4;
    if (const auto known = known_transform(first_info, info)) {
      const Registration nearby = register_views(first, view, {*known, true});
      if (!nearby.trusted() || displacement_px(view, *known, nearby.initial_from_final) < contradicted_px)
        return *known;
      return nearby.initial_from_final;
    }
    const Registration registration = register_views(first, view);
    if (!registration.trusted())
      throw RegistrationRefused(fmt::format("{} captures", name),
                                "they could not be registered: " + registration.doubt,
                                "record them from one base with poses, or from nearly one pose");
    return registration.initial_from_final;
  }

  Registration registration_of(const DepthView& before, const DepthView& after, const CaptureInfo& initial,
                               const CaptureInfo& final) {
    if (const auto known = known_transform(initial, final)) {
      Registration nearby = register_views(before, after, {*known, true});
      if (nearby.trusted()) return nearby;
      detection_.warnings.push_back(fmt::format(
          "the views contradict the poses that the captures state ({}): they were registered without "
          "them",
          nearby.doubt));
    }
    Registration registration = register_views(before, after);
    if (!registration.trusted())
      throw RegistrationRefused(
          "initial and final", "the views could not be registered: " + registration.doubt,
          "record both so that they show the same ribs and stringers, from poses closer together");
    return registration;
  }

  const SpatialDetectionOptions& options_;
  const Progress& progress_;
  const Mask& left_out_;
  Detection detection_;
  PlacedCaptures placed_;
  std::size_t fewest_captures_ = 0;  // number on the side that has fewer
};

}  // namespace

bool came_back_nearly(const Transform& initial_from_final) {
  constexpr double most_turn_deg = 3.0;
  constexpr double most_shift_m = 0.02;
  return angle_deg_of(initial_from_final) < most_turn_deg &&
         initial_from_final.translation().norm() < most_shift_m;
}

SpatialDetection detect_spatial(const Captures& initial, const Captures& final,
                                const SpatialDetectionOptions& options, const Progress& progress,
                                const Mask& left_out) {
  return Run(options, progress, left_out).run(initial, final);
}

nlohmann::ordered_json json_of(const Registration& registration) {
  nlohmann::ordered_json json{{"format", "rva-registration"}, {"version", 1}};
  json["initial_from_final"] = to_row_major(registration.initial_from_final);
  json["covariance"] = nlohmann::ordered_json::array();
  for (Eigen::Index row = 0; row < 6; ++row) {
    for (Eigen::Index column = 0; column < 6; ++column)
      json["covariance"].push_back(registration.covariance(row, column));
  }
  json["agreeing"] = registration.agreeing;
  json["overlap"] = registration.overlap;
  json["offset_px"] = registration.offset_px;
  return json;
}

}  // namespace rva
