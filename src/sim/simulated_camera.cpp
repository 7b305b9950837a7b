#include "sim/simulated_camera.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/random.hpp"
#include "core/units.hpp"
#include "scene/camera_stand.hpp"

namespace rva {

namespace {

constexpr double frames_per_s = 30.0;

// The gain of the imagers in the unit of RealSense cameras, in which 16 is a factor of one.
constexpr double least_gain = 16.0;
constexpr double greatest_gain = 248.0;

// Electrons per unit of light that an exposure of a microsecond collects.
constexpr double e_per_us = longest_exposure_e / (us_per_s * longest_exposure_s);

const StereoSensorOptions& checked(const StereoSensorOptions& options) {
  check_options(options);
  if (options.window_px % 2 == 0)
    throw OptionError("window", "must be odd, so that the window is centred on a pixel",
                      "give 5, 7, 9, 11 or 13");
  return options;
}

// The pose is rounded to 1e-6, so that two computations of one view yield the same speckle.
std::uint64_t seed_of(const Transform& world_from_camera, std::uint64_t device) {
  std::uint64_t seed = device;
  for (const double number : to_row_major(world_from_camera)) seed = mix(seed, std::llround(number * 1e6));
  return seed;
}

// The speckle patterns of one view. They depend on the stand's pan and tilt if speckle persists over small
// turns, otherwise on the exact pose.
std::vector<SpeckleShare> speckle_of(const CameraStand& stand, const Transform& world_from_camera,
                                     const StereoSensorOptions& options) {
  if (options.speckle_turn_deg <= 0.0) return {{seed_of(world_from_camera, options.device), 1.0}};
  return speckle_shares({stand.pan_deg, stand.tilt_deg}, options.speckle_turn_deg,
                        seed_of(world_from_foot(stand), options.device));
}

// A bay that is not rigid leaves the camera at a slightly different position each time it comes to rest.
Transform swayed(const Transform& world_from_camera, double sway_mm, std::uint64_t seed) {
  if (sway_mm <= 0.0) return world_from_camera;
  Random random(mix(seed, 0x5A1));
  Eigen::Vector3d offset_m;
  for (double& along : offset_m) along = m_per_mm * sway_mm * random.normal();
  return Eigen::Translation3d(offset_m) * world_from_camera;
}

// Reduces the imager's 10 bits to the 8 bits of a camera frame.
FineGrayImage brightness_of(const InfraredImage& infrared) {
  FineGrayImage gray(infrared.width(), infrared.height());
  std::ranges::transform(infrared.pixels(), gray.pixels().begin(), [](auto counts) {
    return static_cast<std::uint16_t>((counts >> 2U) * fine_steps_per_grey_level);
  });
  return gray;
}

}  // namespace

SimulatedCamera::SimulatedCamera(Scene scene, const StereoSensorOptions& options, std::uint64_t seed,
                                 ColorFrames color_frames, std::function<PanTilt()> joints,
                                 std::function<double()> lamp)
    : scene_(std::move(scene)),
      options_(checked(options)),
      seed_(seed),
      color_frames_(color_frames),
      joints_(std::move(joints)),
      lamp_(std::move(lamp)),
      rays_(scene_),
      infrared_(scene_, rays_, options_),
      rig_(stereo_rig(options_)) {
  if (!joints_)
    joints_ = [pan_tilt = PanTilt{scene_.stand.pan_deg, scene_.stand.tilt_deg}] { return pan_tilt; };
}

// The lamp of the camera and that of its robot are the same one.
OwnLight SimulatedCamera::own_light() const {
  if (light_ == Light::lamp) return {.projector = false, .lamp = 1.0};
  return {.projector = true, .lamp = lamp_ ? lamp_() : 0.0};
}

CameraStand SimulatedCamera::stand() const {
  CameraStand stand = scene_.stand;
  const PanTilt joints = joints_();
  stand.pan_deg = joints.pan_deg;
  stand.tilt_deg = joints.tilt_deg;
  return stand;
}

Transform SimulatedCamera::world_from_camera() const { return rva::world_from_camera(stand()); }

TrueView SimulatedCamera::true_view() const { return infrared_.true_view(world_from_camera()); }

CaptureInfo SimulatedCamera::info() const {
  const PanTilt joints = joints_();
  CaptureInfo info;
  info.format = "rva-capture";
  info.depth = rig_.imager;
  info.depth_unit_m = options_.depth_unit_mm / mm_per_m;
  if (color_frames_ != ColorFrames::none) {
    info.color = rig_.color;
    info.color_from_depth = rig_.color_from_depth;
  }
  info.pose = Pose{scene_.stand.base, joints.pan_deg, joints.tilt_deg, world_from_camera()};
  info.camera = CameraInfo{"RVA simulated stereo camera", "simulated-" + std::to_string(options_.device),
                           rig_.baseline_m};
  return info;
}

std::optional<ExposureControl> SimulatedCamera::exposure_control() const {
  return ExposureControl{.set = {.automatic = options_.exposure == 0.0,
                                 .time_us = sensor_ ? sensor_->exposure_us() : options_.exposure / e_per_us,
                                 .gain = least_gain * options_.gain},
                         .time_us = {1.0, us_per_s * longest_exposure_s},
                         .gain = {least_gain, greatest_gain}};
}

void SimulatedCamera::set_exposure(const Exposure& exposure) {
  options_.exposure = exposure.automatic ? 0.0 : exposure.time_us * e_per_us;
  options_.gain = exposure.automatic ? 1.0 : exposure.gain / least_gain;
  if (sensor_) sensor_->set_exposure(options_.exposure, options_.gain);
}

bool SimulatedCamera::wants_color(bool moving) const {
  switch (color_frames_) {
    case ColorFrames::none:
      return false;
    case ColorFrames::first:
      return number_ == 0;
    case ColorFrames::all:
      return !moving || number_ % 2 == 0;
  }
  return false;
}

void SimulatedCamera::render(const Transform& world_from_camera, const OwnLight& light) {
  const bool moving = rendered_ == Rendered::moving;
  StereoSensorOptions options = options_;
  if (moving) {
    // A view that lasts for one frame cannot show speckle that changes over several frames.
    options.wander = 0.0;
    options.levels = 0.0;
    options.supersampling = 1;
  }
  const std::uint64_t capture_seed = mix(seed_, moving ? 0 : rests_);
  const Transform pose =
      moving ? world_from_camera : swayed(world_from_camera, options.sway_mm, capture_seed);
  InfraredPair pair =
      infrared_.render(pose, misalignment_of(options_, capture_seed), options.supersampling, light);
  if (light.projector && wants_color(moving))
    color_ = render_color(scene_, rays_, rig_, pose, options.supersampling, light.lamp);
  sensor_ = std::make_unique<StereoSensor>(std::move(pair), options,
                                           speckle_of(stand(), world_from_camera, options),
                                           moving ? mix(capture_seed, number_) : capture_seed);
  rendered_pose_ = world_from_camera;
  rendered_light_ = light;
}

std::optional<CameraFrame> SimulatedCamera::wait_for_frame() {
  throw_if_interrupted();
  const Transform pose = world_from_camera();
  const OwnLight light = own_light();
  const bool same = rendered_ != Rendered::nothing && pose.matrix() == rendered_pose_.matrix();
  const bool moving = rendered_ != Rendered::nothing && !same;
  if (!same || rendered_ == Rendered::moving) {
    rendered_ = moving ? Rendered::moving : Rendered::resting;
    if (!moving) ++rests_;
    render(pose, light);
  } else if (rendered_light_ != light) {
    render(pose, light);
  }
  StereoFrame stereo = light_ == Light::lamp ? sensor_->next_pair() : sensor_->next_frame();
  left_infrared_ = std::move(stereo.left);
  right_infrared_ = std::move(stereo.right);
  CameraFrame frame;
  frame.depth = light_ == Light::lamp ? DepthImage(rig_.imager.width, rig_.imager.height, no_depth)
                                      : std::move(stereo.depth);
  frame.number = number_;
  frame.time_s = static_cast<double>(number_) / frames_per_s;
  if (light_ == Light::projector && wants_color(moving))
    frame.color = expose_color(color_, mix(seed_, 0xC0104, number_));
  frame.infrared.emplace(Imager::left, brightness_of(left_infrared_));
  frame.infrared.emplace(Imager::right, brightness_of(right_infrared_));
  frame.metadata.exposure_us = sensor_->exposure_us();
  frame.metadata.gain = least_gain * options_.gain;
  if (light_ == Light::lamp) frame.metadata.laser_power_mw = 0.0;
  ++number_;
  return frame;
}

}  // namespace rva
