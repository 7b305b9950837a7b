// A camera whose frames are also passed to an observer.
#pragma once

#include <functional>

#include "camera/camera.hpp"

namespace rva {

/// Forwards the frames of another camera, and passes each frame taken under the projector to `see`, which may
/// throw to end the work. Adds the current time to info() as the time of the capture. The other camera must
/// outlive this object.
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
