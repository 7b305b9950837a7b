#include "inspect/watched_camera.hpp"

#include <utility>

#include "core/date_time.hpp"

namespace rva {

WatchedCamera::WatchedCamera(Camera& camera, std::function<void(const CameraFrame&)> see)
    : camera_(camera), see_(std::move(see)) {}

CaptureInfo WatchedCamera::info() const {
  CaptureInfo info = camera_.info();
  info.captured_at = iso_8601_now();
  return info;
}

void WatchedCamera::set_light(Light light) {
  camera_.set_light(light);
  light_ = light;
}

std::optional<CameraFrame> WatchedCamera::wait_for_frame() {
  std::optional<CameraFrame> frame = camera_.wait_for_frame();
  if (frame && light_ == Light::projector) see_(*frame);
  return frame;
}

}  // namespace rva
