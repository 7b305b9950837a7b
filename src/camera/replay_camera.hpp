// A camera that replays a capture.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>

#include "camera/camera.hpp"
#include "capture/capture.hpp"
#include "core/clock.hpp"
#include "core/options.hpp"

namespace rva {

/// Options of the replay of a capture as a camera.
struct ReplayOptions {
  double rate_hz = 30.0;  ///< frames per second, which captures do not state
  bool paced = true;      ///< whether frames come at the rate, or else as fast as they are asked for
  bool loop = false;      ///< whether the recording starts again at its end, without end

  static void describe(auto&& self, auto&& visit) {
    visit(self.rate_hz, OptionField{"rate", "hz", 0.01, 1000,
                                    "frames a second of the recording, which captures do not state"});
    visit(self.paced,
          OptionField{"paced", "", 0, 1, "1: frames come at the rate; 0: as fast as they are asked for"});
    visit(self.loop, OptionField{"loop", "", 0, 1, "1: the recording starts again at its end, without end"});
  }
};

/// Gives all frames of a capture in their order, with their colour and infrared images and metadata. A frame
/// that is requested late is returned at once, and the following ones at the rate from then on. Under the
/// lamp, every request returns the mean of the capture's images under the lamp. Numbers and times continue
/// when the recording starts again; times are number / rate.
class ReplayCamera : public Camera {
 public:
  /// @param capture as open_capture() gives it
  /// @throws UsageError when an option is out of range
  explicit ReplayCamera(std::unique_ptr<Capture> capture, const ReplayOptions& options = {},
                        Clock clock = steady_clock());

  [[nodiscard]] CaptureInfo info() const override { return capture_->info(); }
  [[nodiscard]] std::optional<CameraFrame> wait_for_frame() override;
  [[nodiscard]] bool has_lamp() const override { return capture_->has_infrared(Imager::left, Light::lamp); }
  void set_light(Light light) override { light_ = light; }

 private:
  [[nodiscard]] double next_due_s() const;
  [[nodiscard]] CameraFrame under_lamp() const;

  std::unique_ptr<Capture> capture_;
  ReplayOptions options_;
  Clock clock_;
  std::uint64_t next_ = 0;
  Light light_ = Light::projector;
  double due_s_ = -std::numeric_limits<double>::infinity();  // of the next frame; the first is due at once
};

}  // namespace rva
