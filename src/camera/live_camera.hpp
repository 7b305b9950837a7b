// Shares one camera among viewers and recorders.
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

/// A frame, and the description of the camera when it was taken.
struct LiveFrame {
  CameraFrame frame;                               ///< as the camera delivered it
  CaptureInfo info;                                ///< Camera::info() when the frame was delivered
  std::chrono::system_clock::time_point taken_at;  ///< when the camera delivered it
};

/// The state of a camera.
struct CameraHealth {
  std::uint64_t frames = 0;  ///< number of frames received
  std::uint64_t lost = 0;    ///< number of frames missing, by gaps in their numbers
  double rate_hz = 0.0;      ///< average over about the last second
  double silence_s = 0.0;    ///< since the last frame; before the first one, since the object was constructed
  std::string problem;       ///< a sentence for the user; empty while frames arrive
};

/// Reads a camera on a thread of its own. Viewers take the newest frame and may miss frames; recorders take
/// every frame, through a Camera of their own. Neither delays the other or the camera.
///
/// A recorder may switch to the lamp. Frames under the lamp are passed only to the recorders that asked for
/// it, since they have no depth to show.
///
/// After a failure, the camera is tried again until it works. Every member may be called from any thread.
class LiveCamera {
 public:
  /// @param most_hz highest frame rate, for cameras that deliver frames as fast as they are requested
  explicit LiveCamera(std::unique_ptr<Camera> camera, double most_hz = 30.0);
  ~LiveCamera();
  LiveCamera(const LiveCamera&) = delete;
  LiveCamera& operator=(const LiveCamera&) = delete;

  /// The newest frame under the projector, shared; null before the first one.
  [[nodiscard]] std::shared_ptr<const LiveFrame> newest() const;

  /// Waits up to `limit` for a frame other than `seen`. @return null when none arrived
  [[nodiscard]] std::shared_ptr<const LiveFrame> wait_for_other(const LiveFrame* seen,
                                                                std::chrono::milliseconds limit) const;

  /// A camera that gives each frame from now on once. Up to 30 frames are kept until they are read; older
  /// ones are dropped, which leaves a gap in the frame numbers, as with a device. Its calls throw Error when
  /// the camera fails or gives no frame for five seconds, and Interrupted when a signal is to end the
  /// program. It must be destroyed before this object.
  /// @param while_waiting called ten times a second while waiting for a frame; what it throws ends the wait
  [[nodiscard]] std::unique_ptr<Camera> every_frame(std::function<void()> while_waiting = {});

  /// The state when it is called.
  [[nodiscard]] CameraHealth health() const;

  /// The exposure when the newest frame arrived; empty where it cannot be set, and before the first frame.
  [[nodiscard]] std::optional<ExposureControl> exposure_control() const;

  /// Sets the exposure of one of the next frames and of all later ones. What the device then refuses is
  /// reported by health().
  /// @throws Error when the exposure cannot be set, or a value is out of range
  void set_exposure(const Exposure& exposure);

  /// Whether the camera has a lamp beside its imagers (Camera::has_lamp()).
  [[nodiscard]] bool has_lamp() const { return camera_->has_lamp(); }

 private:
  class Reader;

  void run(const std::stop_token& stop);
  void publish(CameraFrame frame, Light light);
  [[nodiscard]] Light wanted_light() const;
  void set_wanted_exposure();
  void report(const Error& failure);

  std::unique_ptr<Camera> camera_;
  double most_hz_;
  mutable std::mutex mutex_;  // guards everything below
  mutable std::condition_variable changed_;
  std::shared_ptr<const LiveFrame> newest_;
  std::optional<ExposureControl> exposure_control_;
  std::optional<Exposure> wanted_exposure_;  // until it is set
  std::optional<std::uint64_t> last_number_;
  CameraHealth health_;
  std::optional<Error> failure_;  // the last one
  std::uint64_t problems_ = 0;
  double last_frame_s_;
  std::list<Reader*> readers_;
  std::jthread thread_;  // last, since it uses everything above
};

}  // namespace rva
