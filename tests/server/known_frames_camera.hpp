// A camera whose frames a test makes, with colour and infrared images.
#pragma once

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <utility>

#include "camera/camera.hpp"

namespace rva::test {

/// Frames that wait to be taken. The test ends them before the camera's owner is destroyed.
class Frames {
 public:
  static constexpr int width = 32;
  static constexpr int height = 24;

  /// A grey image and a flat wall.
  void give(std::uint64_t number, std::uint16_t depth = 800, std::uint8_t grey = 100) {
    CameraFrame frame{DepthImage(width, height, depth), ColorImage(width, height, Rgb{grey, grey, grey}),
                      number, 0.0};
    frame.infrared[Imager::left] =
        FineGrayImage(width, height, static_cast<std::uint16_t>(fine_steps_per_grey_level * grey));
    add(std::move(frame));
  }
  void give_depth_only(std::uint64_t number) {
    add(CameraFrame{DepthImage(width, height, 800), std::nullopt, number, 0.0});
  }
  void end() { add(std::nullopt); }

  std::optional<CameraFrame> take() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !frames_.empty(); });
    std::optional<CameraFrame> frame = std::move(frames_.front());
    frames_.pop_front();
    return frame;
  }

 private:
  void add(std::optional<CameraFrame> frame) {
    const std::lock_guard lock(mutex_);
    frames_.push_back(std::move(frame));
    changed_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::optional<CameraFrame>> frames_;
};

class KnownFramesCamera : public Camera {
 public:
  explicit KnownFramesCamera(std::shared_ptr<Frames> frames) : frames_(std::move(frames)) {}
  [[nodiscard]] CaptureInfo info() const override {
    CaptureInfo info;
    info.depth = {Frames::width, Frames::height, 30.0, 30.0, 15.5, 11.5};
    info.color = info.depth;
    info.depth_unit_m = 0.001;
    return info;
  }
  [[nodiscard]] std::optional<CameraFrame> wait_for_frame() override { return frames_->take(); }

 private:
  std::shared_ptr<Frames> frames_;
};

}  // namespace rva::test
