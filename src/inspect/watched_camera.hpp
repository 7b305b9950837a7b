// A camera whose frames somebody else sees go by.
#pragma once

#include <functional>

#include "camera/camera.hpp"

namespace rva {

/// Passes on what another camera gives, and shows each frame under the projector to `see`, which may throw to
/// end the work. Says of its captures when they were taken. Refers to the other camera.
class WatchedCamera : public Camera {
 public:
  WatchedCamera(Camera& camera, std::function<void(const CameraFrame&)> see);

  [[nodiscard]] CaptureInfo info() const override;
  [[nodiscard]] std::optional<CameraFrame> wait_for_frame() override;
  void drop_waiting() override { camera_.drop_waiting(); }
  [[nodiscard]] bool has_lamp() const override { return camera_.has_lamp(); }
  void set_light(Light light) override;

 private:
  Camera& camera_;
  Light light_ = Light::projector;
  std::function<void(const CameraFrame&)> see_;
};

}  // namespace rva
