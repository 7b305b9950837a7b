// A recording in the place of a camera.
#pragma once

#include <cstdint>
#include <limits>
#include <memory>

#include "camera/camera.hpp"
#include "core/clock.hpp"
#include "core/options.hpp"
#include "depth/capture.hpp"

namespace rva {

struct ReplayOptions {
  double rate_hz = 30.0;
  bool paced = true;
  bool loop = false;

  static void describe(auto&& self, auto&& visit) {
    visit(self.rate_hz, OptionField{"rate", "hz", 0.01, 1000,
                                    "frames a second of the recording, which captures do not say"});
    visit(self.paced,
          OptionField{"paced", "", 0, 1, "1: frames come at the rate; 0: as fast as they are asked for"});
    visit(self.loop, OptionField{"loop", "", 0, 1, "1: the recording starts again at its end, without end"});
  }
};

/// Gives the frames of a capture in their order, none left out: one that is asked for late comes at once, and
/// later ones at the rate from there. Each has what the capture has with it: colour, infrared, metadata.
/// A frame under the lamp is the mean of what the capture has under it, as often as it is asked for. Numbers
/// and times go on when the recording starts again; times are number / rate.
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
  double due_s_ = -std::numeric_limits<double>::infinity();  // of the next frame; the first comes at once
};

}  // namespace rva
