// A simulated depth camera in front of a scene from a file.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

#include "camera/camera.hpp"
#include "geometry/pan_tilt.hpp"
#include "scene/ray_caster.hpp"
#include "scene/scene.hpp"
#include "sim/sensor/color_renderer.hpp"
#include "sim/sensor/infrared_renderer.hpp"
#include "sim/sensor/stereo_sensor.hpp"

namespace rva {

/// The seed of all noise where the user chooses none.
inline constexpr std::uint64_t default_seed = 1;

/// Which frames have a colour image.
enum class ColorFrames { none, first, all };

/// A simulated stereo camera behind the common camera interface, with the noise of src/sim/sensor. Its pose
/// follows from the joint angles at the time a frame is requested. While it moves, every frame shows a view
/// of its own, rendered at one ray per pixel, and every second frame has a colour image, as with a colour
/// imager that must expose for two frames. Once it rests, the view is rendered in full and kept until the
/// next move.
///
/// Frames depend only on scene, options, seed, lights and poses. They never end and are not paced by a clock:
/// the timestamp of frame n is n / 30 s.
class SimulatedCamera : public Camera {
 public:
  /// @param joints returns the true joint angles; without it, those of the scene's stand apply
  /// @param lamp   returns the brightness of the robot's lamp beside the imagers, 0 to 1 of its full light;
  ///               without it, that lamp is off
  /// @throws UsageError when an option is out of range or the matcher's window is even
  SimulatedCamera(Scene scene, const StereoSensorOptions& options, std::uint64_t seed,
                  ColorFrames color_frames = ColorFrames::all, std::function<PanTilt()> joints = {},
                  std::function<double()> lamp = {});

  [[nodiscard]] CaptureInfo info() const override;
  [[nodiscard]] std::optional<CameraFrame> wait_for_frame() override;
  [[nodiscard]] bool has_lamp() const override { return options_.lamp_light > 0.0; }
  void set_light(Light light) override { light_ = light; }
  [[nodiscard]] std::optional<ExposureControl> exposure_control() const override;
  void set_exposure(const Exposure& exposure) override;

  /// The true depth and labels at the pose of the next frame.
  [[nodiscard]] TrueView true_view() const;
  /// The pose of the depth imager at the current joint angles.
  [[nodiscard]] Transform world_from_camera() const;
  /// The infrared images of the last frame, 10 bits per pixel; empty before the first frame.
  [[nodiscard]] const InfraredImage& left_infrared() const { return left_infrared_; }
  /// The right infrared image of the last frame, likewise.
  [[nodiscard]] const InfraredImage& right_infrared() const { return right_infrared_; }

  /// The scene that the camera sees.
  [[nodiscard]] const Scene& scene() const { return scene_; }
  /// The options of the sensor, as given or set since.
  [[nodiscard]] const StereoSensorOptions& options() const { return options_; }
  /// The seed of all noise, as given.
  [[nodiscard]] std::uint64_t seed() const { return seed_; }

 private:
  [[nodiscard]] bool wants_color(bool moving) const;
  [[nodiscard]] CameraStand stand() const;  // with the current joint angles
  [[nodiscard]] OwnLight own_light() const;
  void render(const Transform& world_from_camera, const OwnLight& light);

  Scene scene_;
  StereoSensorOptions options_;
  std::uint64_t seed_;
  ColorFrames color_frames_;
  std::function<PanTilt()> joints_;
  std::function<double()> lamp_;
  RayCaster rays_;
  InfraredRenderer infrared_;
  StereoRig rig_;
  std::uint64_t number_ = 0;
  std::uint64_t rests_ = 0;  // views rendered in full so far
  Transform rendered_pose_ = Transform::Identity();
  enum class Rendered { nothing, moving, resting } rendered_ = Rendered::nothing;
  Light light_ = Light::projector;
  OwnLight rendered_light_;
  std::unique_ptr<StereoSensor> sensor_;
  ColorView color_;
  InfraredImage left_infrared_;
  InfraredImage right_infrared_;
};

}  // namespace rva
