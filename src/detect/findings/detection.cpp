#include "detect/findings/detection.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "capture/frame_reader.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"
#include "core/stopwatch.hpp"
#include "core/units.hpp"

namespace rva {
namespace {

// The tolerance of a millionth of a degree accepts rounding in files, but not a servo step.
bool differ(const std::optional<double>& a_deg, const std::optional<double>& b_deg) {
  return a_deg && b_deg && std::abs(*a_deg - *b_deg) > 1e-6;
}

}  // namespace

bool poses_differ(const CaptureInfo& initial, const CaptureInfo& final) {
  if (!initial.pose || !final.pose) return false;
  const Pose& a = *initial.pose;
  const Pose& b = *final.pose;
  const bool bases_differ = a.base && b.base && *a.base != *b.base;
  const bool transforms_differ = a.world_from_camera && b.world_from_camera &&
                                 !a.world_from_camera->isApprox(*b.world_from_camera, 1e-9);
  return bases_differ || transforms_differ || differ(a.pan_deg, b.pan_deg) || differ(a.tilt_deg, b.tilt_deg);
}

void require_one_device(const CaptureInfo& initial, const CaptureInfo& final) {
  if (!initial.camera || !final.camera) return;
  const std::string& before = initial.camera->serial;
  const std::string& after = final.camera->serial;
  if (before.empty() || after.empty() || before == after) return;
  throw Error("initial and final",
              fmt::format("were taken with different cameras (serial numbers {} and {})", printable(before),
                          printable(after)),
              "give the baseline that was taken with this camera");
}

std::size_t frames_to_use(const Capture& capture, int wanted, std::string_view side,
                          std::vector<std::string>& warnings) {
  const std::size_t available = capture.depth_frames();
  if (wanted == 0 && available > DepthStatistics::max_frames) {
    throw Error(fmt::format("{} capture", side),
                fmt::format("{} frames are more than can be used", available),
                fmt::format("use at most {} frames", DepthStatistics::max_frames));
  }
  if (wanted == 0) return available;
  const auto count = static_cast<std::size_t>(wanted);
  if (count > available) {
    warnings.push_back(fmt::format("the {} capture has {} frame(s) where {} were asked for: all are used",
                                   side, available, count));
  }
  return std::min(available, count);
}

DepthStatistics statistics_of(const Capture& capture, std::size_t frames, const Progress& progress,
                              Runtime& runtime) {
  const Stopwatch start;
  double adding_ms = 0.0;
  DepthStatistics statistics(capture.info().depth.width, capture.info().depth.height);
  for_each_depth_frame(capture, frames, progress, [&](const DepthImage& frame) {
    const Stopwatch add_start;
    statistics.add(frame);
    adding_ms += add_start.ms();
  });
  runtime.statistics_ms += adding_ms;
  runtime.load_ms += start.ms() - adding_ms;
  return statistics;
}

void warn_of_blindness(const Comparison& comparison, std::string_view why,
                       std::vector<std::string>& warnings) {
  constexpr double little = 0.5;
  constexpr double much = 0.05;
  const double compared = comparison.coverage.compared;
  if (compared < little * (1.0 - comparison.coverage.left_out.value_or(0.0))) {
    warnings.push_back(fmt::format("only {:.1f} % of the view could be compared", 100.0 * compared));
  }
  if (comparison.blind > much) {
    warnings.push_back(
        fmt::format("in {:.0f} % of what was compared, a change of {:.0f} mm would not have been found: {}",
                    100.0 * comparison.blind, mm_per_m * blind_from_m, why));
  }
}

}  // namespace rva
