// A camera whose frames the test releases.
#pragma once

#include <condition_variable>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

#include "camera/camera.hpp"
#include "core/error.hpp"
#include "tests/depth/stacks.hpp"

namespace rva::test {

/// What the test and the camera share; the camera may be gone before.
class CameraScript {
 public:
  void give(std::uint64_t number, std::uint16_t depth = 500) { add(Event{number, depth, ""}); }
  void fail(const std::string& problem) { add(Event{0, 0, problem}); }
  void end() { add(std::nullopt); }

 private:
  friend class ScriptedCamera;
  struct Event {
    std::uint64_t number = 0;
    std::uint16_t depth = 0;
    std::string problem;
  };
  void add(std::optional<Event> event) {
    const std::lock_guard lock(mutex_);
    events_.push_back(std::move(event));
    changed_.notify_all();
  }
  std::optional<Event> take() {
    std::unique_lock lock(mutex_);
    changed_.wait(lock, [&] { return !events_.empty(); });
    std::optional<Event> event = std::move(events_.front());
    events_.pop_front();
    return event;
  }

  std::mutex mutex_;
  std::condition_variable changed_;
  std::deque<std::optional<Event>> events_;
};

/// Waits for the script; end the script before the camera's owner goes.
class ScriptedCamera : public Camera {
 public:
  explicit ScriptedCamera(std::shared_ptr<CameraScript> script) : script_(std::move(script)) {}
  [[nodiscard]] CaptureInfo info() const override { return info_of(8, 6); }
  [[nodiscard]] std::optional<CameraFrame> wait_for_frame() override {
    const auto event = script_->take();
    if (!event) return std::nullopt;
    if (!event->problem.empty()) throw Error("camera", event->problem, "plug it in");
    CameraFrame frame{DepthImage(8, 6, event->depth), std::nullopt, event->number, 0.0};
    if (light_ == Light::lamp) frame.metadata.laser_power_mw = 0.0;
    return frame;
  }
  [[nodiscard]] bool has_lamp() const override { return true; }
  void set_light(Light light) override { light_ = light; }

 private:
  Light light_ = Light::projector;
  std::shared_ptr<CameraScript> script_;
};

}  // namespace rva::test
