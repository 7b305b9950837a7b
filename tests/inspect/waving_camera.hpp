// A small camera that can be unplugged, for captures that take no time.
#pragma once

#include <atomic>
#include <chrono>
#include <memory>
#include <thread>

#include "camera/camera.hpp"
#include "core/error.hpp"
#include "core/random.hpp"

namespace rva::test {

struct Plug {
  std::atomic<bool> pulled = false;
  std::atomic<int> frames_before_pull = -1;  ///< it pulls itself after so many; -1: never
  std::atomic<int> bump_mm = 0;              ///< height of what lies in the middle
  std::atomic<bool> frozen = false;          ///< the last image is given again and again
};

/// A wall at 0.8 m with a little noise, 160 x 120.
class WavingCamera : public Camera {
 public:
  static constexpr int width = 160;
  static constexpr int height = 120;
  explicit WavingCamera(std::shared_ptr<Plug> plug) : plug_(std::move(plug)) {}

  [[nodiscard]] CaptureInfo info() const override {
    CaptureInfo info;
    info.format = "rva-capture";
    info.depth = {width, height, 212.0, 212.0, 79.5, 59.5};
    info.depth_unit_m = 0.0001;
    info.camera = CameraInfo{"waving", "1", 0.05};
    return info;
  }
  [[nodiscard]] std::optional<CameraFrame> wait_for_frame() override {
    std::this_thread::sleep_for(std::chrono::milliseconds(2));
    if (plug_->frames_before_pull >= 0 && plug_->frames_before_pull-- == 0) plug_->pulled = true;
    if (plug_->pulled) throw Error("camera", "was unplugged", "plug it in");
    if (plug_->frozen && !last_.empty()) return CameraFrame{last_, std::nullopt, number_++, 0.0};
    DepthImage depth(width, height);
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        const bool on_bump = std::abs(u - 80) < 14 && std::abs(v - 60) < 14;
        const double depth_mm = 800.0 - (on_bump ? plug_->bump_mm.load() : 0) + 0.5 * random_.normal();
        depth(u, v) = static_cast<std::uint16_t>(10.0 * depth_mm);
      }
    }
    last_ = depth;
    return CameraFrame{std::move(depth), std::nullopt, number_++, 0.0};
  }
  [[nodiscard]] std::optional<ExposureControl> exposure_control() const override {
    return ExposureControl{exposure_, {1.0, 33000.0}, {16.0, 248.0}};
  }
  void set_exposure(const Exposure& exposure) override { exposure_ = exposure; }

 private:
  Exposure exposure_{.automatic = true, .time_us = 8500.0, .gain = 16.0};
  std::shared_ptr<Plug> plug_;
  Random random_{11};
  std::uint64_t number_ = 0;
  DepthImage last_;
};

}  // namespace rva::test
