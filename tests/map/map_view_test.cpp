#include "map/map_view.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "tests/depth/stacks.hpp"

namespace rva {
namespace {

CaptureInfo info_at(double pan_deg, double tilt_deg) {
  CaptureInfo info = test::info_of(8, 6);
  info.pose = Pose{"here", pan_deg, tilt_deg, Transform::Identity()};
  return info;
}

TEST(MapView, IsTheMeanOfTheFramesAtItsJoints) {
  std::vector<DepthImage> frames{DepthImage(8, 6, 1000), DepthImage(8, 6, 1002)};
  const MapView view = load_map_view(test::MemoryCapture(info_at(12.0, -7.0), frames), "a view");
  EXPECT_EQ(view.joints, (PanTilt{12.0, -7.0}));
  EXPECT_EQ(view.name, "a view");
  EXPECT_FALSE(view.color);
  const double depth = view.depth.stereo.depth_m(static_cast<double>(view.depth.disparity_px[0]));
  EXPECT_NEAR(depth, 1001.0 * info_at(0, 0).depth_unit_m, 1e-6);
}

TEST(MapView, NeedsToKnowTheJoints) {
  const std::vector<DepthImage> frames{DepthImage(8, 6, 1000)};
  EXPECT_THAT([&] { (void)load_map_view(test::MemoryCapture(test::info_of(8, 6), frames), "a view"); },
              testing::ThrowsMessage<Error>(testing::HasSubstr("a view: does not state the joint angles")));
}

}  // namespace
}  // namespace rva
