#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "sim/simulated_camera.hpp"
#include "tests/sim/simulated_frames.hpp"
#include "tests/sim/small_scenes.hpp"

namespace rva {
namespace {

/// Root mean square of the difference between two infrared images, in levels.
double difference_of(const InfraredImage& a, const InfraredImage& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += std::pow(a[i] - b[i], 2);
  return std::sqrt(sum / static_cast<double>(a.size()));
}

TEST(SimulatedMotion, FollowsTheJoints) {
  PanTilt joints;
  SimulatedCamera camera(test::room_with_wall(0.6), test::quick(), 1, ColorFrames::none,
                         [&joints] { return joints; });
  for (const PanTilt& target : {PanTilt{0, 0}, {20, -35}}) {
    joints = target;
    const CameraFrame frame = *camera.wait_for_frame();
    EXPECT_EQ(camera.info().pose->pan_deg, target.pan_deg);
    const auto truth_m = static_cast<double>(camera.true_view().depth_m(424, 240));
    EXPECT_NEAR(test::middle_depth_m(frame.depth), truth_m, 0.02 * truth_m);
  }
  const double turned = 35.0 * std::numbers::pi / 180.0;
  EXPECT_GT(static_cast<double>(camera.true_view().depth_m(424, 240)), 0.58 / std::cos(turned));
}

TEST(SimulatedMotion, RendersInFullAsSoonAsItRests) {
  StereoSensorOptions options = test::without_hard_noise();
  options.supersampling = 2;
  options.lens_blur_px = 0.0;
  options.read_noise_e = 0.0;
  options.full_well_e = 1e6;
  options.exposure = 1e5;
  PanTilt joints{10, 0};
  SimulatedCamera camera(test::room_with_wall(0.6), options, 1, ColorFrames::none,
                         [&joints] { return joints; });
  static_cast<void>(camera.wait_for_frame());
  const InfraredImage resting = camera.left_infrared();
  joints = {10.5, 0};
  static_cast<void>(camera.wait_for_frame());
  joints = {10, 0};
  static_cast<void>(camera.wait_for_frame());
  const double moving = difference_of(camera.left_infrared(), resting);
  static_cast<void>(camera.wait_for_frame());
  EXPECT_LT(difference_of(camera.left_infrared(), resting), 1.5);
  EXPECT_GT(moving, 3.0);
}

}  // namespace
}  // namespace rva
