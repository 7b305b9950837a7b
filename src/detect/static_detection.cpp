#include "detect/static_detection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "capture/capture_view.hpp"
#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/stopwatch.hpp"
#include "geometry/stereo_scale.hpp"

namespace rva {
namespace {

bool close(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

void require_one_camera(const CaptureInfo& initial, const CaptureInfo& final) {
  require_one_device(initial, final);
  const Intrinsics& a = initial.depth;
  const Intrinsics& b = final.depth;
  if (a.width != b.width || a.height != b.height) {
    throw Error("initial and final",
                fmt::format("depth of {}x{} and of {}x{} pixels", a.width, a.height, b.width, b.height),
                "record both with the same settings");
  }
  // The tolerance accepts rounding in files, but not another camera or resolution.
  constexpr double tolerance_px = 0.01;
  const bool same = close(a.fx, b.fx, tolerance_px) && close(a.fy, b.fy, tolerance_px) &&
                    close(a.cx, b.cx, tolerance_px) && close(a.cy, b.cy, tolerance_px) &&
                    a.distortion == b.distortion && a.coefficients == b.coefficients;
  if (!same) {
    throw Error("initial and final",
                "the depth intrinsics differ, so a pixel does not see the same point in both",
                "record both with the same camera and settings");
  }
  if (!is_same_unit(initial.depth_unit_m, final.depth_unit_m)) {
    throw Error("initial and final",
                fmt::format("depth units of {} m and of {} m", initial.depth_unit_m, final.depth_unit_m),
                "record both with the same settings");
  }
}

// Recovers the depth image from statistics over a single frame.
DepthImage first_frame(const DepthStatistics& statistics) {
  DepthImage frame(statistics.width(), statistics.height());
  for (std::size_t i = 0; i < frame.size(); ++i) frame[i] = static_cast<std::uint16_t>(statistics.sum(i));
  return frame;
}

class Run {
 public:
  Run(const Capture& initial, const Capture& final, const StaticDetectionOptions& options,
      const Progress& progress, const Mask& left_out)
      : initial_(initial), final_(final), options_(options), progress_(progress), left_out_(left_out) {
    check_options(options);
    require_one_camera(initial.info(), final.info());
  }

  StaticDetection run() {
    const Stopwatch start;
    DepthStatistics before = statistics(initial_, "initial", findings().initial_frames);
    DepthStatistics after = statistics(final_, "final", findings().final_frames);
    Comparison comparison = compare(before, after);
    const Stopwatch regions_start;
    findings().findings = find_findings(comparison, options_.regions, final_.info().depth);
    findings().runtime.regions_ms = regions_start.ms();
    findings().runtime.total_ms = start.ms();
    throw_if_interrupted();
    warn_of_blindness(comparison,
                      "depth varied, because something moved while a capture was recorded or edges flickered",
                      result_.warnings);
    findings().method = name_of(options_.method);
    findings().coverage = comparison.coverage;
    state_parameters(options_.regions);
    result_.changed = std::move(comparison.changed);
    result_.final_m = std::move(comparison.final_m);
    result_.left_out = left_out_;
    return {std::move(result_), std::move(before), std::move(after)};
  }

 private:
  Findings& findings() { return result_.findings; }

  template <typename Options>
  void state_parameters(const Options& options) {
    Options::describe(options, [&](const auto& value, const OptionField& field) {
      findings().parameters.emplace_back(json_name(field), value);
    });
  }

  DepthStatistics statistics(const Capture& capture, std::string_view side, std::size_t& frames) {
    const bool first_alone = options_.method == StaticMethod::constant;
    frames = first_alone ? 1 : frames_to_use(capture, options_.frames, side, result_.warnings);
    return statistics_of(capture, frames, progress_, findings().runtime);
  }

  Comparison compare(const DepthStatistics& before, const DepthStatistics& after) {
    const Stopwatch start;
    Comparison comparison = compare_by_method(before, after);
    findings().runtime.detect_ms = start.ms();
    return comparison;
  }

  Comparison compare_by_method(const DepthStatistics& before, const DepthStatistics& after) {
    switch (options_.method) {
      case StaticMethod::constant:
        return constant(before, after);
      case StaticMethod::gaussian:
        return gaussian(before, after);
      case StaticMethod::calibrated:
        return calibrated(before, after);
    }
    throw std::logic_error("a static method without an implementation");
  }

  Comparison constant(const DepthStatistics& before, const DepthStatistics& after) {
    state_parameters(options_.constant);
    return compare_constant(first_frame(before), first_frame(after), final_.info().depth_unit_m,
                            options_.constant, left_out_);
  }

  [[nodiscard]] bool has_single_frames() const {
    return std::min(result_.findings.initial_frames, result_.findings.final_frames) < 2;
  }

  Comparison calibrated(const DepthStatistics& before, const DepthStatistics& after) {
    if (has_single_frames()) {
      result_.warnings.emplace_back(
          "a single frame does not show noise over time: differences between the captures that are found in "
          "most of the image were taken for noise, and wrong matches may be reported as changes (record 10 "
          "frames or more)");
    }
    state_parameters(options_.calibrated);
    const CaptureInfo& info = final_.info();
    const StereoScale stereo = stereo_scale(info);
    DisparityChange change = disparity_change(before, after, stereo);
    leave_out(change, left_out_);
    if (!initial_.marks_no_depth_by_zero() || !final_.marks_no_depth_by_zero()) forget_losses(change);
    CalibratedComparison calibrated =
        compare_calibrated(change, stereo, usual_slopes(change.frames), options_.calibrated);
    result_.level_of_detection =
        LevelOfDetection{std::move(calibrated.level_of_detection_mm), std::move(calibrated.levels)};
    return std::move(calibrated.comparison);
  }

  Comparison gaussian(const DepthStatistics& before, const DepthStatistics& after) {
    if (has_single_frames()) {
      throw Error("gaussian",
                  "a single frame has no deviation; this method needs at least two of either capture",
                  "record and use more frames (40 make a good inspection), or use the constant method");
    }
    state_parameters(options_.gaussian);
    return compare_gaussian(before, after, final_.info().depth_unit_m, options_.gaussian, left_out_);
  }

  const Capture& initial_;
  const Capture& final_;
  const StaticDetectionOptions& options_;
  const Progress& progress_;
  const Mask& left_out_;
  Detection result_;
};

}  // namespace

StaticDetection detect_static(const Capture& initial, const Capture& final,
                              const StaticDetectionOptions& options, const Progress& progress,
                              const Mask& left_out) {
  return Run(initial, final, options, progress, left_out).run();
}

std::string_view name_of(StaticMethod method) {
  switch (method) {
    case StaticMethod::constant:
      return "constant";
    case StaticMethod::gaussian:
      return "gaussian";
    case StaticMethod::calibrated:
      return "calibrated";
  }
  throw std::logic_error("a static method without a name");
}

}  // namespace rva
