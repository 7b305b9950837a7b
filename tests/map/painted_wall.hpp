// A camera before a painted wall: pictures without aliasing, and exact depth, of any pose of a robot.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <numbers>
#include <optional>
#include <utility>

#include "camera/camera.hpp"
#include "core/random.hpp"
#include "geometry/pan_tilt.hpp"

namespace rva::test {

struct PaintedWallOptions {
  bool lamp = true;
  bool color = false;
  bool depth = true;
  double contrast = 10.0;  ///< of the paint, grey levels
  double noise = 0.0;      ///< of each frame, grey levels
  std::uint64_t seed = 1;  ///< of noise
};

/// The wall is 1 m in front of the foot of the robot. Its paint is a sum of waves, of 25 to 150 mm each.
class PaintedWall : public Camera {
 public:
  PaintedWall(std::function<PanTilt()> joints, const PaintedWallOptions& options = {})
      : joints_(std::move(joints)), options_(options), noise_(options.seed) {
    Random random(5);
    for (Wave& wave : waves_) {
      const double turns_per_m = 1.0 / random.uniform(0.025, 0.15);
      const double direction = random.uniform(0.0, std::numbers::pi);
      wave = {2.0 * std::numbers::pi * turns_per_m * std::cos(direction),
              2.0 * std::numbers::pi * turns_per_m * std::sin(direction), random.uniform(0.0, 6.28)};
    }
  }

  [[nodiscard]] CaptureInfo info() const override {
    CaptureInfo info;
    info.format = "rva-capture";
    info.depth = imager();
    info.depth_unit_m = unit_m;
    info.camera = CameraInfo{"painted wall", "1", 0.05};
    if (options_.color) {
      info.color = imager();
      info.color_from_depth = color_from_depth();
    }
    return info;
  }

  [[nodiscard]] std::optional<CameraFrame> wait_for_frame() override {
    const Transform foot_from_depth = foot_from_camera(PanTiltChain{}, joints_()) * loose;
    if (on_frame) on_frame(number_);
    CameraFrame frame{depth_from(foot_from_depth), {}, number_++, 0.0};
    frame.infrared.emplace(Imager::left, fine_gray(picture_from(foot_from_depth)));
    if (options_.color) {
      const Image<float> picture = picture_from(foot_from_depth * color_from_depth().inverse());
      frame.color = ColorImage(picture.width(), picture.height());
      for (std::size_t i = 0; i < picture.size(); ++i) {
        const auto level = static_cast<std::uint8_t>(std::lround(picture[i]));
        (*frame.color)[i] = {level, level, level};
      }
    }
    return frame;
  }

  [[nodiscard]] bool has_lamp() const override { return options_.lamp; }
  void set_light(Light selected) override { light = selected; }

  Light light = Light::projector;
  Transform loose = Transform::Identity();        ///< of the camera on its bracket
  std::function<void(std::uint64_t)> on_frame{};  ///< called with the number of each frame

 private:
  struct Wave {
    double across = 0.0;  // rad/m
    double up = 0.0;
    double phase = 0.0;
  };
  static constexpr double unit_m = 0.0001;

  static Intrinsics imager() {
    Intrinsics camera;
    camera.width = 320;
    camera.height = 180;
    camera.fx = camera.fy = 300.0;
    camera.cx = 159.5;
    camera.cy = 89.5;
    return camera;
  }
  static Transform color_from_depth() { return Transform(Eigen::Translation3d(0.015, 0.0, 0.0)); }

  // The distance along the ray of a pixel, whose z is 1, to the wall.
  static double distance_m(const Transform& foot_from_imager, const Eigen::Vector3d& ray) {
    return (1.0 - foot_from_imager.translation().y()) / ray.y();
  }
  static Eigen::Vector3d ray_of(const Transform& foot_from_imager, int u, int v) {
    return foot_from_imager.linear() * imager().deproject({u, v}, 1.0);
  }

  [[nodiscard]] DepthImage depth_from(const Transform& foot_from_depth) const {
    DepthImage depth(imager().width, imager().height, no_depth);
    if (!options_.depth) return depth;
    for (int v = 0; v < depth.height(); ++v) {
      for (int u = 0; u < depth.width(); ++u)
        depth(u, v) = static_cast<std::uint16_t>(
            std::lround(distance_m(foot_from_depth, ray_of(foot_from_depth, u, v)) / unit_m));
    }
    return depth;
  }

  [[nodiscard]] Image<float> picture_from(const Transform& foot_from_imager) {
    Image<float> picture(imager().width, imager().height);
    for (int v = 0; v < picture.height(); ++v) {
      for (int u = 0; u < picture.width(); ++u) {
        const Eigen::Vector3d ray = ray_of(foot_from_imager, u, v);
        const Eigen::Vector3d point =
            foot_from_imager.translation() + distance_m(foot_from_imager, ray) * ray;
        double level = 100.0 + options_.noise * noise_.normal();
        for (const Wave& wave : waves_)
          level += options_.contrast * std::sin(wave.across * point.x() + wave.up * point.z() + wave.phase);
        picture(u, v) = static_cast<float>(std::clamp(level, 0.0, 255.0));
      }
    }
    return picture;
  }

  std::function<PanTilt()> joints_;
  PaintedWallOptions options_;
  Random noise_;
  std::array<Wave, 12> waves_;
  std::uint64_t number_ = 0;
};

}  // namespace rva::test
