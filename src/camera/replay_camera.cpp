#include "camera/replay_camera.hpp"

#include <utility>

namespace rva {

ReplayCamera::ReplayCamera(std::unique_ptr<Capture> capture, const ReplayOptions& options, Clock clock)
    : capture_(std::move(capture)), options_(options), clock_(std::move(clock)) {
  check_options(options_);
}

// Counted from the previous due time, so that short delays do not add up; after a delay of more than a
// period, from now.
double ReplayCamera::next_due_s() const {
  const double period_s = 1.0 / options_.rate_hz;
  const double now_s = clock_.now_s();
  return (now_s - due_s_ > period_s ? now_s : due_s_) + period_s;
}

CameraFrame ReplayCamera::under_lamp() const {
  CameraFrame frame;
  frame.depth = DepthImage(capture_->info().depth.width, capture_->info().depth.height, no_depth);
  for (const Imager imager : both_imagers) {
    if (const auto mean = capture_->infrared_mean(imager, Light::lamp))
      frame.infrared.emplace(imager, fine_gray(*mean));
  }
  const InfraredBurst burst = capture_->info().lamp.value_or(InfraredBurst{});
  frame.metadata.exposure_us = burst.exposure_us;
  frame.metadata.gain = burst.gain;
  frame.metadata.laser_power_mw = burst.laser_power_mw;
  frame.number = next_;
  return frame;
}

std::optional<CameraFrame> ReplayCamera::wait_for_frame() {
  if (light_ == Light::lamp) return under_lamp();
  const std::size_t frames = capture_->depth_frames();
  if (next_ >= frames && !options_.loop) return std::nullopt;
  const std::size_t i = next_ % frames;
  CameraFrame frame;
  frame.depth = capture_->depth(i);
  frame.color = capture_->color_of(i);
  frame.infrared = infrared_of(*capture_, i);
  frame.metadata = capture_->metadata_of(i);
  frame.number = next_;
  frame.time_s = static_cast<double>(next_) / options_.rate_hz;
  if (options_.paced) {
    wait_until(clock_, due_s_);
    due_s_ = next_due_s();
  }
  ++next_;
  return frame;
}

}  // namespace rva
