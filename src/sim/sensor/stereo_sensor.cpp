#include "sim/sensor/stereo_sensor.hpp"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "core/random.hpp"
#include "stereo/correlation.hpp"
#include "stereo/semi_global.hpp"

namespace rva {
namespace {

std::vector<SpeckleShare> of_imager(std::vector<SpeckleShare> view, std::uint64_t imager) {
  for (SpeckleShare& share : view) share.seed = mix(share.seed, imager);
  return view;
}

}  // namespace

StereoSensor::StereoSensor(InfraredPair view, const StereoSensorOptions& options,
                           const std::vector<SpeckleShare>& speckle, std::uint64_t capture_seed)
    : view_(std::move(view)),
      options_(options),
      capture_seed_(capture_seed),
      left_speckle_(view_.left.steady.width(), view_.left.steady.height(), options, of_imager(speckle, 1),
                    mix(capture_seed, 1)),
      right_speckle_(view_.right.steady.width(), view_.right.steady.height(), options, of_imager(speckle, 2),
                     mix(capture_seed, 2)) {
  set_exposure(options.exposure, options.gain);
}

void StereoSensor::set_exposure(double exposure, double gain) {
  options_.exposure = exposure;
  options_.gain = gain;
  exposure_e_ = exposure > 0.0 ? exposure : automatic_exposure(view_.left, options_);
}

StereoFrame StereoSensor::next_pair() {
  left_speckle_.advance();
  right_speckle_.advance();
  const std::uint64_t seed = mix(capture_seed_, 0xE390, frame_++);
  const double exposure_e = exposure_e_ * std::max(0.0, 1.0 + options_.flicker * Random(seed).normal());
  return {expose(view_.left, left_speckle_, exposure_e, options_, mix(seed, 1)),
          expose(view_.right, right_speckle_, exposure_e * (1.0 + options_.imager_difference), options_,
                 mix(seed, 2)),
          {}};
}

double StereoSensor::exposure_us() const {
  return 1e6 * exposure_e_ / longest_exposure_e * longest_exposure_s;
}

StereoFrame StereoSensor::next_frame() {
  StereoFrame frame = next_pair();
  frame.depth = depth_from_disparity(match_stereo(frame.left, frame.right, options_), options_);
  return frame;
}

Image<std::uint16_t> match_stereo(const InfraredImage& left, const InfraredImage& right,
                                  const StereoSensorOptions& options) {
  switch (options.matcher) {
    case Matcher::semi_global:
      return match_semi_globally(left, right);
    case Matcher::correlation:
      return match_by_correlation(left, right, {.window_px = options.window_px});
    case Matcher::census:
      break;
  }
  constexpr int wider_px = 2;  // compensates for the fit's weights, which fade towards the window's edge
  const int fitted_px = std::min(options.window_px + wider_px, SubpixelOptions{}.window_px);
  return refine_disparity(left, right, match_blocks(left, right, {.window_px = options.window_px}),
                          {.window_px = fitted_px});
}

DepthImage depth_from_disparity(const Image<std::uint16_t>& disparity, const StereoSensorOptions& options) {
  constexpr double greatest = 65535.0;
  const double steps_per_px = std::ldexp(1.0, SubpixelOptions{}.fraction_bits);
  const double numerator = options.focal_px * options.baseline_mm / options.depth_unit_mm * steps_per_px;
  std::vector<std::uint16_t> depth_of(1, no_depth);
  DepthImage depth(disparity.width(), disparity.height(), no_depth);
  for (std::size_t i = 0; i < depth.size(); ++i) {
    while (depth_of.size() <= disparity[i]) {
      const double units = std::round(numerator / static_cast<double>(depth_of.size()));
      depth_of.push_back(units <= greatest ? static_cast<std::uint16_t>(units) : no_depth);
    }
    depth[i] = depth_of[disparity[i]];
  }
  return depth;
}

}  // namespace rva
