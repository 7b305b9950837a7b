// A simulated bay before and after the work.
#pragma once

#include <atomic>
#include <functional>
#include <memory>

#include "camera/camera.hpp"
#include "geometry/pan_tilt.hpp"
#include "sim/simulated_camera.hpp"

namespace rva {

/// One camera in front of either of two scenes that differ in nothing else. Frame numbers continue when the
/// scene changes.
class SimulatedBay : public Camera {
 public:
  /// @param before, after scenes with the same camera stand
  /// @param seed          seed of the camera's noise
  /// @param joints, lamp  as for SimulatedCamera
  SimulatedBay(Scene before, Scene after, std::uint64_t seed, const std::function<PanTilt()>& joints,
               const std::function<double()>& lamp = {});

  /// Selects the scene from the next frame on: `after` if done, else `before`. Callable from any thread.
  void set_work_done(bool done) { done_ = done; }

  [[nodiscard]] CaptureInfo info() const override { return now().info(); }
  [[nodiscard]] std::optional<CameraFrame> wait_for_frame() override;
  [[nodiscard]] bool has_lamp() const override { return before_.has_lamp(); }
  void set_light(Light light) override;
  [[nodiscard]] std::optional<ExposureControl> exposure_control() const override {
    return now().exposure_control();
  }
  void set_exposure(const Exposure& exposure) override;

 private:
  [[nodiscard]] const SimulatedCamera& now() const { return done_ ? after_ : before_; }

  SimulatedCamera before_;
  SimulatedCamera after_;
  std::atomic<bool> done_ = false;
  std::uint64_t number_ = 0;
};

}  // namespace rva
