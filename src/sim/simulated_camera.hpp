// A depth camera in front of a scene that exists only as a file.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "camera/camera.hpp"
#include "geometry/pan_tilt.hpp"
#include "sim/scene/ray_caster.hpp"
#include "sim/scene/scene.hpp"
#include "sim/sensor/color_renderer.hpp"
#include "sim/sensor/infrared_renderer.hpp"
#include "sim/sensor/stereo_sensor.hpp"

namespace rva {

/// Which frames come with a colour image.
enum class ColorFrames { none, first, all };

/// Behind the interface that every camera has, with the noise of src/sim/sensor. It is where its robot's
/// joints are when a frame is asked for. While it moves, each frame is of a view of its own, rendered at one
/// ray a pixel, and every second one brings a colour image, as a colour imager does that must expose for two
/// frames; as soon as it rests, the view is rendered in full and held.
///
/// Frames depend on scene, options, seed and poses alone. There is no end, and nothing waits for a clock:
/// frame n is dated n / 30 s.
class SimulatedCamera : public Camera {
 public:
  /// @param joints where the joints really are; without it, they stay as the scene's stand says
  /// @throws UsageError when an option is out of range
  SimulatedCamera(Scene scene, const StereoSensorOptions& options, std::uint64_t seed,
                  ColorFrames color_frames = ColorFrames::all, std::function<PanTilt()> joints = {});

  [[nodiscard]] CaptureInfo info() const override;
  [[nodiscard]] std::optional<CameraFrame> wait_for_frame() override;
  [[nodiscard]] bool has_lamp() const override { return options_.lamp_light > 0.0; }
  void set_light(Light light) override { light_ = light; }

  /// Of the pose that the next frame would have.
  [[nodiscard]] TrueView look() const;
  [[nodiscard]] Transform world_from_camera() const;
  /// The infrared images of the last frame, 10 bits; empty before the first.
  [[nodiscard]] const InfraredImage& left_infrared() const { return left_infrared_; }
  [[nodiscard]] const InfraredImage& right_infrared() const { return right_infrared_; }

  [[nodiscard]] const Scene& scene() const { return scene_; }

 private:
  [[nodiscard]] bool wants_color(bool moving) const;
  [[nodiscard]] CameraStand stand() const;  // turned as the joints are
  void render(const Transform& world_from_camera);

  Scene scene_;
  StereoSensorOptions options_;
  std::uint64_t seed_;
  ColorFrames color_frames_;
  std::function<PanTilt()> joints_;
  RayCaster rays_;
  InfraredRenderer infrared_;
  StereoRig rig_;
  std::uint64_t number_ = 0;
  std::uint64_t rests_ = 0;  // views rendered in full so far
  Transform rendered_pose_ = Transform::Identity();
  enum class Rendered { nothing, moving, resting } rendered_ = Rendered::nothing;
  Light light_ = Light::projector;
  Light rendered_light_ = Light::projector;
  std::unique_ptr<StereoSensor> sensor_;
  ColorView color_;
  InfraredImage left_infrared_;
  InfraredImage right_infrared_;
};

}  // namespace rva
