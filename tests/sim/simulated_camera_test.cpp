#include "sim/simulated_camera.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/error.hpp"
#include "tests/sim/simulated_frames.hpp"
#include "tests/sim/small_scenes.hpp"

namespace rva {
namespace {

TEST(SimulatedCamera, FramesAreOfTheSeed) {
  SimulatedCamera camera(test::room_with_wall(1.0), test::quick(), 5, ColorFrames::first);
  SimulatedCamera same(test::room_with_wall(1.0), test::quick(), 5, ColorFrames::first);
  SimulatedCamera other(test::room_with_wall(1.0), test::quick(), 6, ColorFrames::first);
  for (int k = 0; k < 2; ++k) {
    const CameraFrame frame = *camera.wait_for_frame();
    const CameraFrame again = *same.wait_for_frame();
    EXPECT_EQ(frame.depth, again.depth);
    EXPECT_EQ(frame.color, again.color);
    EXPECT_EQ(camera.left_infrared(), same.left_infrared());
    EXPECT_EQ(camera.right_infrared(), same.right_infrared());
    EXPECT_EQ(frame.color.has_value(), k == 0);
    if (k > 0) continue;
    const CameraFrame different = *other.wait_for_frame();
    EXPECT_NE(frame.depth, different.depth);
    EXPECT_NE(frame.color, different.color);
    EXPECT_NE(camera.left_infrared(), other.left_infrared());
  }
}

TEST(SimulatedCamera, InABayThatGivesWayItRestsElsewhereEachTime) {
  PanTilt joints;
  StereoSensorOptions options = test::quick();
  options.speckle = options.wander = options.levels = options.drift_px = options.flicker = 0.0;
  const auto depth_of_rests = [&](double sway_mm) {
    options.sway_mm = sway_mm;
    SimulatedCamera camera(test::room_with_wall(1.0), options, 3, ColorFrames::none,
                           [&joints] { return joints; });
    std::vector<double> depths_m;
    for (int k = 0; k < 12; ++k) {
      joints.pan_deg = 5.0;
      (void)camera.wait_for_frame();
      joints.pan_deg = 0.0;
      (void)camera.wait_for_frame();
      depths_m.push_back(test::middle_depth_m(camera.wait_for_frame()->depth));
    }
    const auto [least, most] = std::ranges::minmax(depths_m);
    return most - least;
  };
  EXPECT_LT(depth_of_rests(0.0), 0.0005);
  EXPECT_GT(depth_of_rests(20.0), 0.02);
  EXPECT_EQ(
      SimulatedCamera(test::room_with_wall(1.0), options, 3).info().pose->world_from_camera->matrix(),
      SimulatedCamera(test::room_with_wall(1.0), test::quick(), 3).info().pose->world_from_camera->matrix())
      << "the robot does not measure it";
}

TEST(SimulatedCamera, SeesTheRobotsLampInColorAndInfraredAsSoonAsItIsSwitched) {
  Scene room = test::room_with_wall(1.0);
  room.lighting.visible = 0.0;
  StereoSensorOptions options = test::quick();
  options.exposure = 4000.0;
  double lamp = 0.0;
  SimulatedCamera camera(
      room, options, 5, ColorFrames::all, [] { return PanTilt{}; }, [&lamp] { return lamp; });
  const auto mean = [](const auto& image, const auto& level) {
    double sum = 0.0;
    for (const auto& pixel : image.pixels()) sum += level(pixel);
    return sum / static_cast<double>(image.pixels().size());
  };
  struct Levels {
    double color = 0.0;
    double infrared = 0.0;
  };
  const auto levels_at = [&](double share) {
    lamp = share;
    const CameraFrame frame = *camera.wait_for_frame();
    return Levels{mean(*frame.color, [](Rgb pixel) { return static_cast<double>(pixel.g); }),
                  mean(camera.left_infrared(), [](auto counts) { return static_cast<double>(counts); })};
  };
  const Levels dark = levels_at(0.0);
  const Levels once = levels_at(0.1);
  const Levels twice = levels_at(0.2);
  EXPECT_LT(dark.color, 12.0);
  EXPECT_GT(once.color, 2.0 * dark.color);
  EXPECT_GT(twice.color, once.color);
  EXPECT_NEAR(twice.infrared - dark.infrared, 2.0 * (once.infrared - dark.infrared),
              0.05 * (twice.infrared - dark.infrared));
  EXPECT_GT(once.infrared, 1.1 * dark.infrared);
  EXPECT_NEAR(levels_at(0.0).infrared, dark.infrared, 0.05 * dark.infrared);
}

TEST(SimulatedCamera, CountsAndDatesItsFrames) {
  SimulatedCamera camera(test::room_with_wall(1.0), test::quick(), 1, ColorFrames::none);
  EXPECT_TRUE(camera.left_infrared().empty());
  DepthImage last;
  for (std::uint64_t k = 0; k < 2; ++k) {
    const CameraFrame frame = *camera.wait_for_frame();
    EXPECT_EQ(frame.number, k);
    EXPECT_DOUBLE_EQ(frame.time_s, static_cast<double>(k) / 30.0);
    EXPECT_FALSE(frame.color);
    EXPECT_NE(frame.depth, last);
    EXPECT_NEAR(test::middle_depth_m(frame.depth), 1.0, 0.005);
    last = frame.depth;
  }
}

double mean_counts(const InfraredImage& infrared) {
  double sum = 0.0;
  for (const auto counts : infrared.pixels()) sum += counts;
  return sum / static_cast<double>(infrared.size());
}

TEST(SimulatedCamera, ExposesAsItIsSet) {
  StereoSensorOptions options = test::quick();
  options.flicker = 0.0;
  SimulatedCamera camera(test::room_with_wall(1.0), options, 1, ColorFrames::none);
  SimulatedCamera untouched(test::room_with_wall(1.0), options, 1, ColorFrames::none);
  (void)camera.wait_for_frame();
  (void)untouched.wait_for_frame();
  const ExposureControl automatic = *camera.exposure_control();
  EXPECT_TRUE(automatic.set.automatic);
  const double automatic_counts = mean_counts(camera.left_infrared());
  const auto counts_at = [&](double time_us, double gain) {
    camera.set_exposure({.automatic = false, .time_us = time_us, .gain = gain});
    const CameraFrame frame = *camera.wait_for_frame();
    EXPECT_NEAR(*frame.metadata.exposure_us, time_us, 1e-6 * time_us);
    EXPECT_NEAR(*frame.metadata.gain, gain, 1e-6 * gain);
    EXPECT_FALSE(camera.exposure_control()->set.automatic);
    (void)untouched.wait_for_frame();
    return mean_counts(camera.left_infrared());
  };
  const double time_us = automatic.set.time_us;
  EXPECT_NEAR(counts_at(time_us, 16.0), automatic_counts, 0.01 * automatic_counts);
  EXPECT_NEAR(counts_at(time_us / 2, 16.0), automatic_counts / 2, 0.02 * automatic_counts);
  EXPECT_NEAR(counts_at(time_us / 2, 32.0), automatic_counts, 0.02 * automatic_counts);
  EXPECT_GT(counts_at(automatic.time_us.greatest, 248.0), 900.0) << "saturated";
  camera.set_exposure({.automatic = true});
  EXPECT_EQ(camera.wait_for_frame()->depth, untouched.wait_for_frame()->depth) << "as if it had not been set";
}

TEST(SimulatedCamera, BringsEverySecondColorImageWhileItMoves) {
  PanTilt joints;
  SimulatedCamera camera(test::room_with_wall(1.0), test::quick(), 1, ColorFrames::all,
                         [&joints] { return joints; });
  const auto color_after = [&](double pan_deg) {
    joints.pan_deg += pan_deg;
    return camera.wait_for_frame()->color;
  };
  EXPECT_TRUE(color_after(0.0));
  EXPECT_FALSE(color_after(0.5));
  const std::optional<ColorImage> moved = color_after(0.5);
  ASSERT_TRUE(moved);
  EXPECT_FALSE(color_after(0.5));
  const std::optional<ColorImage> rested = color_after(0.0);
  ASSERT_TRUE(rested);
  EXPECT_NE(*rested, *moved);
  EXPECT_TRUE(color_after(0.0)) << "at rest, every frame has one";
}

TEST(SimulatedCamera, SaysWhatItIsAndWhereItStands) {
  Scene scene = test::room_with_wall(1.0);
  scene.stand.base = "b7";
  scene.stand.pan_deg = 12.0;
  StereoSensorOptions options = test::quick();
  options.baseline_mm = 60.0;
  options.depth_unit_mm = 0.5;
  options.device = 9;
  const SimulatedCamera camera(scene, options, 1, ColorFrames::first);
  const CaptureInfo info = camera.info();
  EXPECT_EQ(info.pose->base, "b7");
  EXPECT_EQ(info.pose->pan_deg, 12.0);
  EXPECT_EQ(info.pose->tilt_deg, 0.0);
  EXPECT_TRUE(info.pose->world_from_camera->isApprox(camera.world_from_camera(), 1e-12));
  EXPECT_DOUBLE_EQ(info.depth_unit_m, 0.0005);
  EXPECT_DOUBLE_EQ(*info.camera->baseline_m, 0.06);
  EXPECT_NE(info.camera->serial.find('9'), std::string::npos);
  EXPECT_EQ(info.depth.width, 848);
  EXPECT_TRUE(info.color && info.color_from_depth);
  EXPECT_FALSE(SimulatedCamera(scene, options, 1, ColorFrames::none).info().color);
}

TEST(SimulatedCamera, RefusesOptionsOutOfRange) {
  std::vector<StereoSensorOptions> impossible(5);
  impossible[0].focal_px = 0.0;
  impossible[1].supersampling = 0;
  impossible[2].speckle = std::nan("");
  impossible[3].depth_unit_mm = -0.1;
  impossible[4].wander_frames = 0.0;
  for (const StereoSensorOptions& options : impossible)
    EXPECT_THROW(SimulatedCamera(test::room_with_wall(1.0), options, 1), UsageError);
}

TEST(SimulatedCamera, SeesNothingInAnEmptyScene) {
  SimulatedCamera camera(Scene{}, test::quick(), 1);
  const CameraFrame frame = *camera.wait_for_frame();
  EXPECT_EQ(frame.depth, DepthImage(848, 480, no_depth));
  EXPECT_TRUE(frame.color);
}

}  // namespace
}  // namespace rva
