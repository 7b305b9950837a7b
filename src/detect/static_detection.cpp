#include "detect/static_detection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>

#include "capture/capture_view.hpp"
#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/stopwatch.hpp"

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

class Run {
 public:
  Run(const Capture& initial, const Capture& final, const StaticDetectionOptions& options,
      const Progress& progress, const Mask& left_out)
      : initial_(initial),
        final_(final),
        options_(options),
        method_(static_method(options.method)),
        progress_(progress),
        left_out_(left_out) {
    check_options(options);
    require_one_camera(initial.info(), final.info());
  }

  StaticDetection run() {
    const Stopwatch start;
    DepthStatistics before = statistics(initial_, "initial", findings().initial_frames);
    DepthStatistics after = statistics(final_, "final", findings().final_frames);
    const Comparison comparison = compare(before, after);
    const Stopwatch regions_start;
    findings().findings = find_findings(comparison, options_.regions, final_.info().depth);
    findings().runtime.regions_ms = regions_start.ms();
    findings().runtime.total_ms = start.ms();
    throw_if_interrupted();
    warn_of_blindness(comparison,
                      "depth varied, because something moved while a capture was recorded or edges flickered",
                      result_.warnings);
    findings().method = name_of(method_.method);
    findings().coverage = comparison.coverage;
    state(options_.regions, findings().parameters);
    result_.changed = comparison.changed;
    result_.initial_m = comparison.initial_m;
    result_.final_m = comparison.final_m;
    result_.left_out = left_out_;
    return {std::move(result_), std::move(before), std::move(after)};
  }

 private:
  Findings& findings() { return result_.findings; }

  DepthStatistics statistics(const Capture& capture, std::string_view side, std::size_t& frames) {
    frames =
        method_.first_frame_only ? 1 : frames_to_use(capture, options_.use.frames, side, result_.warnings);
    return statistics_of(capture, frames, progress_, findings().runtime);
  }

  Comparison compare(const DepthStatistics& before, const DepthStatistics& after) {
    const Stopwatch start;
    StaticComparison compared = method_.compare(
        {.initial = before,
         .final = after,
         .info = final_.info(),
         .left_out = left_out_,
         .losses_count = initial_.marks_no_depth_by_zero() && final_.marks_no_depth_by_zero()},
        options_);
    result_.level_of_detection = std::move(compared.level_of_detection);
    findings().parameters = std::move(compared.parameters);
    std::ranges::move(compared.warnings, std::back_inserter(result_.warnings));
    findings().runtime.detect_ms = start.ms();
    return std::move(compared.comparison);
  }

  const Capture& initial_;
  const Capture& final_;
  const StaticDetectionOptions& options_;
  const StaticMethod& method_;
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

}  // namespace rva
