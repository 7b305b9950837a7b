// One camera for all who look through it.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <list>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "camera/camera.hpp"
#include "core/error.hpp"

namespace rva {

/// A frame, and the view that it had.
struct LiveFrame {
  CameraFrame frame;
  CaptureInfo info;
  std::chrono::system_clock::time_point taken_at;  ///< when it came out of the camera
};

/// How the camera is doing.
struct CameraHealth {
  std::uint64_t frames = 0;  ///< that came
  std::uint64_t lost = 0;    ///< gaps in the camera's numbers
  double rate_hz = 0.0;      ///< of the last second or so
  std::string problem;       ///< a sentence for a person; empty while frames come
};

/// Reads a camera on a thread of its own. Whoever shows pictures takes the newest frame and may miss any;
/// whoever records takes every frame, as a camera of his own. Neither holds up the other, nor the camera.
///
/// A recorder may switch to the lamp. The frames under it go to the recorders that asked for it, and nobody
/// else sees them: they have no depth to show.
///
/// A camera that fails is asked again until it answers. Every member may be called from any thread.
class LiveCamera {
 public:
  /// @param most_hz frames a second at most, for cameras that give them as fast as they are asked
  explicit LiveCamera(std::unique_ptr<Camera> camera, double most_hz = 30.0);
  ~LiveCamera();
  LiveCamera(const LiveCamera&) = delete;
  LiveCamera& operator=(const LiveCamera&) = delete;

  /// Null before the first frame. The frame is shared and constant.
  [[nodiscard]] std::shared_ptr<const LiveFrame> newest() const;

  /// Waits for a frame that is not `seen`, for so long; null when none came.
  [[nodiscard]] std::shared_ptr<const LiveFrame> wait_for_other(const LiveFrame* seen,
                                                                std::chrono::milliseconds limit) const;

  /// The frames from now on, each once. A signal that ends the program ends a wait (Interrupted). The frames
  /// of the last second are kept until they are read; older ones are dropped, which leaves a gap in the frame
  /// numbers, as with a device. It fails when the camera fails or gives no frame for five seconds. It must be
  /// closed before this object.
  /// @param while_waiting called ten times a second while a frame is waited for; what it throws ends the wait
  [[nodiscard]] std::unique_ptr<Camera> every_frame(std::function<void()> while_waiting = {});

  [[nodiscard]] CameraHealth health() const;

  /// Whether the camera has a lamp beside its imagers (Camera::has_lamp()).
  [[nodiscard]] bool has_lamp() const { return camera_->has_lamp(); }

 private:
  class Reader;

  void run(const std::stop_token& stop);
  void publish(CameraFrame frame, Light light);
  [[nodiscard]] Light wanted_light() const;
  void report(const Error& failure);

  std::unique_ptr<Camera> camera_;
  double most_hz_;
  mutable std::mutex mutex_;  // guards all below
  mutable std::condition_variable changed_;
  std::shared_ptr<const LiveFrame> newest_;
  std::optional<std::uint64_t> last_number_;
  CameraHealth health_;
  std::optional<Error> failure_;  // the last one
  std::uint64_t problems_ = 0;
  double last_frame_s_ = 0.0;
  std::list<Reader*> readers_;
  std::jthread thread_;  // last: it uses all above
};

}  // namespace rva
