#include "detect/static_method.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <utility>

#include "core/error.hpp"
#include "geometry/stereo_scale.hpp"
#include "views/disparity_change.hpp"

namespace rva {
namespace {

// Recovers the depth image from statistics over a single frame.
DepthImage first_frame(const DepthStatistics& statistics) {
  DepthImage frame(statistics.width(), statistics.height());
  for (std::size_t i = 0; i < frame.size(); ++i) frame[i] = static_cast<std::uint16_t>(statistics.sum(i));
  return frame;
}

bool have_single_frames(const StaticSides& sides) {
  return std::min(sides.initial.frames(), sides.final.frames()) < 2;
}

template <typename Options>
Parameters parameters_of(const Options& options) {
  Parameters parameters;
  state(options, parameters);
  return parameters;
}

StaticComparison by_constant(const StaticSides& sides, const StaticDetectionOptions& options) {
  return {.comparison = compare_constant(first_frame(sides.initial), first_frame(sides.final),
                                         sides.info.depth_unit_m, options.constant, sides.left_out),
          .parameters = parameters_of(options.constant)};
}

StaticComparison by_gaussian(const StaticSides& sides, const StaticDetectionOptions& options) {
  if (have_single_frames(sides))
    throw Error("gaussian",
                "a single frame has no deviation; this method needs at least two of either capture",
                "record and use more frames (40 make a good inspection), or use the constant method");
  return {.comparison = compare_gaussian(sides.initial, sides.final, sides.info.depth_unit_m,
                                         options.gaussian, sides.left_out),
          .parameters = parameters_of(options.gaussian)};
}

StaticComparison by_calibrated(const StaticSides& sides, const StaticDetectionOptions& options) {
  const StereoScale stereo = stereo_scale(sides.info);
  DisparityChange change = disparity_change(sides.initial, sides.final, stereo);
  leave_out(change, sides.left_out);
  if (!sides.losses_count) forget_losses(change);
  CalibratedComparison calibrated =
      compare_calibrated(change, stereo, prior_slopes(change.frames), options.calibrated);
  StaticComparison result{.comparison = std::move(calibrated.comparison),
                          .level_of_detection = LevelOfDetection{std::move(calibrated.level_of_detection_mm),
                                                                 std::move(calibrated.levels)},
                          .parameters = parameters_of(options.calibrated)};
  if (have_single_frames(sides))
    result.warnings.emplace_back(
        "a single frame does not show noise over time: differences between the captures that are found in "
        "most of the image were taken for noise, and wrong matches may be reported as changes (record 10 "
        "frames or more)");
  return result;
}

constexpr std::array static_methods{StaticMethod{DetectionMethod::constant, true, by_constant},
                                    StaticMethod{DetectionMethod::gaussian, false, by_gaussian},
                                    StaticMethod{DetectionMethod::calibrated, false, by_calibrated}};

}  // namespace

bool is_static(DetectionMethod method) {
  return std::ranges::find(static_methods, method, &StaticMethod::method) != static_methods.end();
}

const StaticMethod& static_method(DetectionMethod method) {
  assert(is_static(method));
  return *std::ranges::find(static_methods, method, &StaticMethod::method);
}

}  // namespace rva
