#include "camera/replay_camera.hpp"

#include <utility>

namespace rva {

ReplayCamera::ReplayCamera(std::unique_ptr<Capture> capture, const ReplayOptions& options, Clock clock)
    : capture_(std::move(capture)), options_(options), clock_(std::move(clock)) {
  check_options(options_);
}

// By the schedule, so that short delays do not add up; after a long one, from now.
double ReplayCamera::next_due_s() const {
  const double period_s = 1.0 / options_.rate_hz;
  const double now_s = clock_.now_s();
  return (now_s - due_s_ > period_s ? now_s : due_s_) + period_s;
}

std::optional<CameraFrame> ReplayCamera::wait_for_frame() {
  const std::size_t frames = capture_->depth_frames();
  if (next_ >= frames && !options_.loop) return std::nullopt;
  const std::size_t i = next_ % frames;
  CameraFrame frame;
  frame.depth = capture_->depth(i);
  frame.color = capture_->color_of(i);
  frame.infrared = capture_->infrared_of(i);
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
