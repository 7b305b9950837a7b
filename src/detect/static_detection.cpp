#include "detect/static_detection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/stopwatch.hpp"

namespace rva {
namespace {

bool close(double a, double b, double tolerance) { return std::abs(a - b) <= tolerance; }

void require_one_camera(const CaptureInfo& initial, const CaptureInfo& final) {
  const Intrinsics& a = initial.depth;
  const Intrinsics& b = final.depth;
  if (a.width != b.width || a.height != b.height) {
    throw Error("initial and final",
                fmt::format("depth of {}x{} and of {}x{} pixels", a.width, a.height, b.width, b.height),
                "record both with the same settings");
  }
  // A hundredth of a pixel: rounding in files passes, another camera or resolution does not.
  constexpr double tolerance_px = 0.01;
  const bool same = close(a.fx, b.fx, tolerance_px) && close(a.fy, b.fy, tolerance_px) &&
                    close(a.cx, b.cx, tolerance_px) && close(a.cy, b.cy, tolerance_px) &&
                    a.distortion == b.distortion && a.coefficients == b.coefficients;
  if (!same) {
    throw Error("initial and final", "the depth intrinsics differ, so pixels do not see the same places",
                "record both with the same camera and settings");
  }
  if (!close(initial.depth_unit_m, final.depth_unit_m, 1e-9 * final.depth_unit_m)) {
    throw Error("initial and final",
                fmt::format("depth units of {} m and of {} m", initial.depth_unit_m, final.depth_unit_m),
                "record both with the same settings");
  }
}

class Run {
 public:
  Run(const Capture& initial, const Capture& final, const StaticDetectionOptions& options,
      const Progress& progress)
      : initial_(initial), final_(final), options_(options), progress_(progress) {
    check_options(options);
    require_one_camera(initial.info(), final.info());
    if (poses_differ(initial.info(), final.info())) {
      result_.warnings.emplace_back(
          "the captures' poses say that the camera moved: pixels were compared all the same, and what "
          "differs "
          "may be the view");
    }
  }

  Detection run() {
    const Stopwatch start;
    Comparison comparison = compare();
    const Stopwatch regions_start;
    findings().findings =
        measure_regions(find_regions(comparison.changed, options_.regions), comparison, final_.info().depth);
    findings().runtime.regions_ms = regions_start.ms();
    findings().runtime.total_ms = start.ms();
    throw_if_interrupted();
    warn_of_blindness(comparison,
                      "depth varied, since something moved while a capture was recorded, or edges flickered",
                      result_.warnings);
    findings().method = name_of(options_.method);
    findings().coverage = comparison.coverage;
    state_parameters(options_.regions);
    result_.changed = std::move(comparison.changed);
    result_.final_m = std::move(comparison.final_m);
    return std::move(result_);
  }

 private:
  Findings& findings() { return result_.findings; }

  template <typename Options>
  void state_parameters(const Options& options) {
    Options::describe(options, [&](const auto& value, const OptionField& field) {
      findings().parameters.emplace_back(json_name(field), value);
    });
  }

  Comparison compare() {
    switch (options_.method) {
      case StaticMethod::constant:
        return constant();
      case StaticMethod::gaussian:
        return gaussian();
      case StaticMethod::calibrated:
        return calibrated();
    }
    throw std::logic_error("a static method without an implementation");
  }

  Comparison constant() {
    const Stopwatch load_start;
    const DepthImage before = initial_.depth(0);
    const DepthImage after = final_.depth(0);
    findings().runtime.load_ms = load_start.ms();
    findings().initial_frames = findings().final_frames = 1;
    state_parameters(options_.constant);
    const Stopwatch detect_start;
    Comparison comparison = compare_constant(before, after, final_.info().depth_unit_m, options_.constant);
    findings().runtime.detect_ms = detect_start.ms();
    return comparison;
  }

  void count_frames() {
    findings().initial_frames = frames_to_use(initial_, options_.frames, "initial", result_.warnings);
    findings().final_frames = frames_to_use(final_, options_.frames, "final", result_.warnings);
  }

  Comparison calibrated() {
    count_frames();
    if (std::min(findings().initial_frames, findings().final_frames) < 2) {
      result_.warnings.emplace_back(
          "one frame says nothing about noise over time: what differs between the captures in most places "
          "was "
          "taken for noise, and wrong matches may pass for changes (record 10 frames or more)");
    }
    const DepthStatistics before = statistics(initial_, findings().initial_frames);
    const DepthStatistics after = statistics(final_, findings().final_frames);
    state_parameters(options_.calibrated);
    const Stopwatch detect_start;
    const CaptureInfo& info = final_.info();
    CalibratedComparison calibrated =
        compare_calibrated(before, after, info.depth_unit_m, disparity_m_px(info), options_.calibrated);
    findings().runtime.detect_ms = detect_start.ms();
    result_.level_of_detection =
        LevelOfDetection{std::move(calibrated.level_of_detection_mm), std::move(calibrated.levels)};
    return std::move(calibrated.comparison);
  }

  Comparison gaussian() {
    count_frames();
    if (std::min(findings().initial_frames, findings().final_frames) < 2) {
      throw Error(
          "gaussian", "one frame has no deviation, and this method needs two of either capture at least",
          "record more frames or raise --frames (40 make a good inspection), or use --method constant");
    }
    const DepthStatistics before = statistics(initial_, findings().initial_frames);
    const DepthStatistics after = statistics(final_, findings().final_frames);
    state_parameters(options_.gaussian);
    const Stopwatch detect_start;
    Comparison comparison = compare_gaussian(before, after, final_.info().depth_unit_m, options_.gaussian);
    findings().runtime.detect_ms = detect_start.ms();
    return comparison;
  }

  DepthStatistics statistics(const Capture& capture, std::size_t frames) {
    return statistics_of(capture, frames, progress_, findings().runtime);
  }

  const Capture& initial_;
  const Capture& final_;
  const StaticDetectionOptions& options_;
  const Progress& progress_;
  Detection result_;
};

}  // namespace

Detection detect_static(const Capture& initial, const Capture& final, const StaticDetectionOptions& options,
                        const Progress& progress) {
  return Run(initial, final, options, progress).run();
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
