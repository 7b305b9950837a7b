#include "detect/static_detection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <stdexcept>

#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "depth/frame_reader.hpp"

namespace rva {
namespace {

using Clock = std::chrono::steady_clock;

double ms_since(Clock::time_point start) {
  return std::chrono::duration<double, std::milli>(Clock::now() - start).count();
}

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

// A millionth of a degree: rounding in files passes, a servo step does not.
bool differ(const std::optional<double>& a_deg, const std::optional<double>& b_deg) {
  return a_deg && b_deg && !close(*a_deg, *b_deg, 1e-6);
}

// What the poses say against a camera that stood still; silent where they say nothing.
std::optional<std::string> moved(const CaptureInfo& initial, const CaptureInfo& final) {
  if (!initial.pose || !final.pose) return std::nullopt;
  const Pose& a = *initial.pose;
  const Pose& b = *final.pose;
  const bool bases_differ = a.base && b.base && *a.base != *b.base;
  const bool poses_differ = a.world_from_camera && b.world_from_camera &&
                            !a.world_from_camera->isApprox(*b.world_from_camera, 1e-9);
  if (!bases_differ && !poses_differ && !differ(a.pan_deg, b.pan_deg) && !differ(a.tilt_deg, b.tilt_deg)) {
    return std::nullopt;
  }
  return "the captures' poses say that the camera moved: pixels were compared all the same, "
         "and what differs may be the view";
}

std::size_t frames_to_use(const Capture& capture, int wanted, std::string_view side,
                          std::vector<std::string>& warnings) {
  const std::size_t available = capture.depth_frames();
  if (wanted == 0 && available > DepthStatistics::max_frames) {
    throw Error(fmt::format("{} capture", side),
                fmt::format("{} frames are more than can be used", available),
                fmt::format("give --frames {}", DepthStatistics::max_frames));
  }
  if (wanted == 0) return available;
  const auto count = static_cast<std::size_t>(wanted);
  if (count > available) {
    warnings.push_back(fmt::format("the {} capture has {} frame(s) where {} were asked for: all are used",
                                   side, available, count));
  }
  return std::min(available, count);
}

// What the figures say against believing an empty list of findings.
void warn_of_blindness(const Comparison& comparison, std::vector<std::string>& warnings) {
  constexpr double little = 0.5;
  constexpr double much = 0.05;
  const double compared = comparison.coverage.compared;
  if (compared < little) {
    warnings.push_back(fmt::format("only {:.1f} % of the view could be compared", 100.0 * compared));
  }
  if (comparison.blind > much) {
    warnings.push_back(
        fmt::format("in {:.0f} % of what was compared, depth varied so much that a change of {:.0f} mm would "
                    "not have been "
                    "found: something moved while a capture was recorded, or edges flickered",
                    100.0 * comparison.blind, 1000.0 * blind_from_m));
  }
}

// Disparities in true pixels need the baseline; without it the unit is that of a camera with 50 mm.
double disparity_m_px(const CaptureInfo& info) {
  constexpr double usual_baseline_m = 0.050;
  const double baseline_m = info.camera && info.camera->baseline_m.value_or(0.0) > 0.0
                                ? *info.camera->baseline_m
                                : usual_baseline_m;
  return info.depth.fx * baseline_m;
}

class Detection {
 public:
  Detection(const Capture& initial, const Capture& final, const StaticDetectionOptions& options,
            const Progress& progress)
      : initial_(initial), final_(final), options_(options), progress_(progress) {
    check_options(options);
    require_one_camera(initial.info(), final.info());
    if (auto warning = moved(initial.info(), final.info())) result_.warnings.push_back(std::move(*warning));
  }

  StaticDetection run() {
    const auto start = Clock::now();
    Comparison comparison = compare();
    const auto regions_start = Clock::now();
    findings().findings =
        measure_regions(find_regions(comparison.changed, options_.regions), comparison, final_.info().depth);
    findings().runtime.regions_ms = ms_since(regions_start);
    findings().runtime.total_ms = ms_since(start);
    throw_if_interrupted();
    warn_of_blindness(comparison, result_.warnings);
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
    const auto load_start = Clock::now();
    const DepthImage before = initial_.depth(0);
    const DepthImage after = final_.depth(0);
    findings().runtime.load_ms = ms_since(load_start);
    findings().initial_frames = findings().final_frames = 1;
    state_parameters(options_.constant);
    const auto detect_start = Clock::now();
    Comparison comparison = compare_constant(before, after, final_.info().depth_unit_m, options_.constant);
    findings().runtime.detect_ms = ms_since(detect_start);
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
    const auto detect_start = Clock::now();
    const CaptureInfo& info = final_.info();
    CalibratedComparison calibrated =
        compare_calibrated(before, after, info.depth_unit_m, disparity_m_px(info), options_.calibrated);
    findings().runtime.detect_ms = ms_since(detect_start);
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
    const auto detect_start = Clock::now();
    Comparison comparison = compare_gaussian(before, after, final_.info().depth_unit_m, options_.gaussian);
    findings().runtime.detect_ms = ms_since(detect_start);
    return comparison;
  }

  DepthStatistics statistics(const Capture& capture, std::size_t frames) {
    const auto start = Clock::now();
    double adding_ms = 0.0;
    DepthStatistics statistics(capture.info().depth.width, capture.info().depth.height);
    for_each_depth_frame(capture, frames, progress_, [&](const DepthImage& frame) {
      const auto add_start = Clock::now();
      statistics.add(frame);
      adding_ms += ms_since(add_start);
    });
    findings().runtime.statistics_ms += adding_ms;
    findings().runtime.load_ms += ms_since(start) - adding_ms;
    return statistics;
  }

  const Capture& initial_;
  const Capture& final_;
  const StaticDetectionOptions& options_;
  const Progress& progress_;
  StaticDetection result_;
};

}  // namespace

StaticDetection detect_static(const Capture& initial, const Capture& final,
                              const StaticDetectionOptions& options, const Progress& progress) {
  return Detection(initial, final, options, progress).run();
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
