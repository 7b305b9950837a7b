#include "cloud/spatial_detection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <nlohmann/json.hpp>
#include <optional>
#include <string_view>

#include "cloud/fused_view.hpp"
#include "cloud/spatial_comparison.hpp"
#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/stopwatch.hpp"

namespace rva {
namespace {

// Where the captures' poses put one in the frame of the other; empty where they say nothing about each other.
std::optional<Transform> known_transform(const CaptureInfo& to, const CaptureInfo& from) {
  if (!to.pose || !from.pose || !to.pose->base || to.pose->base != from.pose->base) return std::nullopt;
  if (!to.pose->world_from_camera || !from.pose->world_from_camera) return std::nullopt;
  return to.pose->world_from_camera->inverse() * *from.pose->world_from_camera;
}

// Of each final capture the initial one of the same pose, by position; none where one of them has none.
std::vector<std::size_t> exact_returns(const Captures& initial, const Captures& final) {
  std::vector<std::size_t> returns;
  for (const auto& capture : final) {
    const auto same = std::ranges::find_if(initial, [&](const auto& candidate) {
      return known_transform(candidate->info(), capture->info()) &&
             candidate->info().depth == capture->info().depth &&
             candidate->info().depth_unit_m == capture->info().depth_unit_m &&
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

class Run {
 public:
  Run(const SpatialDetectionOptions& options, const Progress& progress)
      : options_(options), progress_(progress) {
    check_options(options);
  }

  SpatialDetection run(const Captures& initial, const Captures& final) {
    const Stopwatch start;
    const std::vector<std::size_t> returns =
        options_.exact_poses ? exact_returns(initial, final) : std::vector<std::size_t>{};
    auto [calibrated, registration] =
        returns.empty() ? from_elsewhere(initial, final) : from_the_same_places(initial, final, returns);
    const CaptureInfo& info = final.front()->info();
    Comparison& comparison = calibrated.comparison;
    const Stopwatch regions_start;
    findings().findings =
        measure_regions(find_regions(comparison.changed, options_.regions), comparison, info.depth);
    findings().runtime.regions_ms = regions_start.ms();
    findings().runtime.total_ms = start.ms();
    throw_if_interrupted();
    warn_of_blindness(comparison,
                      "edges and what is far differ too much from place to place (more captures a side, a "
                      "servo step or a few apart, help)",
                      detection_.warnings);
    findings().method = "spatial";
    findings().coverage = comparison.coverage;
    findings().final_from_initial = registration.initial_from_final.inverse();
    state_parameters();
    detection_.level_of_detection =
        LevelOfDetection{std::move(calibrated.level_of_detection_mm), std::move(calibrated.levels)};
    detection_.changed = std::move(comparison.changed);
    detection_.final_m = std::move(comparison.final_m);
    return {std::move(detection_), std::move(registration)};
  }

 private:
  Findings& findings() { return detection_.findings; }

  Compared from_elsewhere(const Captures& initial, const Captures& final) {
    const DepthView before = view_of(initial, "initial", findings().initial_frames);
    const DepthView after = view_of(final, "final", findings().final_frames);
    throw_if_interrupted();
    const Stopwatch start;
    Registration registration = lay_over(before, after, initial.front()->info(), final.front()->info());
    CalibratedComparison calibrated =
        compare_spatial(change_from_elsewhere(before, after, registration),
                        final.front()->info().depth_unit_m, options_.calibrated);
    findings().runtime.detect_ms = fusing_ms_ + start.ms();
    return {std::move(calibrated), std::move(registration)};
  }

  // Where the camera came back exactly, what its matcher gets wrong cancels pixel by pixel.
  Compared from_the_same_places(const Captures& initial, const Captures& final,
                                const std::vector<std::size_t>& returns) {
    const CaptureInfo& first = final.front()->info();
    const double disparity_by_depth = disparity_m_px(first) / first.depth_unit_m;
    std::vector<PlacedChange> changes;
    for (std::size_t k = 0; k < final.size(); ++k) {
      const Capture& capture = *final[k];
      const DepthStatistics before =
          statistics_of(*initial[returns[k]], "initial", findings().initial_frames);
      const DepthStatistics after = statistics_of(capture, "final", findings().final_frames);
      changes.push_back({disparity_change(before, after, disparity_by_depth),
                         known_transform(first, capture.info()).value_or(Transform::Identity())});
    }
    throw_if_interrupted();
    const Stopwatch start;
    CalibratedComparison calibrated =
        compare_spatial(change_from_same_places(std::move(changes), first.depth, disparity_m_px(first)),
                        first.depth_unit_m, options_.calibrated);
    findings().runtime.detect_ms = start.ms();
    Registration registration;
    registration.agreeing = registration.overlap = 1.0;
    return {std::move(calibrated), std::move(registration)};
  }

  DepthStatistics statistics_of(const Capture& capture, std::string_view side, std::size_t& frames) {
    const std::size_t used = frames_to_use(capture, options_.frames, side, detection_.warnings);
    frames += used;
    return rva::statistics_of(capture, used, progress_, findings().runtime);
  }

  void state_parameters() {
    const auto state = [&](const auto& value, const OptionField& field) {
      findings().parameters.emplace_back(json_name(field), value);
    };
    CalibratedOptions::describe(options_.calibrated, state);
    RegionOptions::describe(options_.regions, state);
  }

  // All captures of a side as one view, in the first one's camera.
  DepthView view_of(const Captures& captures, std::string_view side, std::size_t& frames) {
    assert(!captures.empty());
    std::vector<PlacedView> views;
    for (const auto& capture : captures) {
      const CaptureInfo& info = capture->info();
      const DepthStatistics statistics = statistics_of(*capture, side, frames);
      views.push_back({depth_view(statistics, info.depth, info.depth_unit_m, disparity_m_px(info)),
                       Transform::Identity()});
      if (views.size() > 1)
        views.back().first_from_view =
            place(views.front().view, views.back().view, captures.front()->info(), info, side);
    }
    const Stopwatch start;
    DepthView fused = fuse(views);
    fusing_ms_ += start.ms();
    return fused;
  }

  [[nodiscard]] Transform place(const DepthView& first, const DepthView& view, const CaptureInfo& first_info,
                                const CaptureInfo& info, std::string_view side) const {
    if (const auto known = known_transform(first_info, info)) {
      if (options_.exact_poses) return *known;
      const Registration nearby = register_views(first, view, {*known, true});
      if (nearby.trusted()) return nearby.initial_from_final;
    }
    const Registration registration = register_views(first, view);
    if (!registration.trusted())
      throw Error(fmt::format("{} captures", side),
                  "they could not be laid over each other: " + registration.doubt,
                  "record them from one base with poses, or from nearly one place");
    return registration.initial_from_final;
  }

  Registration lay_over(const DepthView& before, const DepthView& after, const CaptureInfo& initial,
                        const CaptureInfo& final) {
    if (const auto known = known_transform(initial, final)) {
      Registration nearby = register_views(before, after, {*known, true});
      if (nearby.trusted()) return nearby;
      detection_.warnings.push_back(
          fmt::format("the views do not fit the poses that the captures state ({}): they were laid over each "
                      "other without",
                      nearby.doubt));
    }
    Registration registration = register_views(before, after);
    if (!registration.trusted())
      throw Error("initial and final", "the views could not be laid over each other: " + registration.doubt,
                  "record both so that they show the same ribs and stringers, from places less far apart");
    return registration;
  }

  const SpatialDetectionOptions& options_;
  const Progress& progress_;
  Detection detection_;
  double fusing_ms_ = 0.0;
};

}  // namespace

SpatialDetection detect_spatial(const Captures& initial, const Captures& final,
                                const SpatialDetectionOptions& options, const Progress& progress) {
  return Run(options, progress).run(initial, final);
}

std::string to_json(const Registration& registration) {
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
  return json.dump(1) + "\n";
}

}  // namespace rva
