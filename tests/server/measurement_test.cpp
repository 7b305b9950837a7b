#include "server/measurement.hpp"

#include <gtest/gtest.h>

namespace rva {
namespace {

// A wall at one metre, and a colour imager 15 mm to the right.
LiveFrame wall() {
  LiveFrame live;
  live.info.depth = {160, 120, 200.0, 200.0, 79.5, 59.5};
  live.info.depth_unit_m = 0.001;
  live.info.color = live.info.depth;
  live.info.color_from_depth = Transform::Identity();
  live.info.color_from_depth->translation().x() = -0.015;
  live.frame.depth = DepthImage(160, 120, 1000);
  return live;
}

TEST(Measurement, GivesDistanceAlongTheLineOfSight) {
  const auto point = measure(wall(), Stream::depth, {119.5, 59.5});
  ASSERT_TRUE(point);
  EXPECT_NEAR(point->position_m.x(), 0.2, 0.003);
  EXPECT_NEAR(point->distance_m, std::hypot(1.0, 0.2), 0.001);
}

TEST(Measurement, LengthsAreOfSpaceNotOfTheImage) {
  const auto a = measure(wall(), Stream::depth, {40, 60});
  const auto b = measure(wall(), Stream::depth, {120, 60});
  EXPECT_NEAR((a->position_m - b->position_m).norm(), 80.0 / 200.0, 1e-9);
}

TEST(Measurement, OnColourItIsTheSurfaceThatIsSeenThere) {
  const auto by_depth = measure(wall(), Stream::depth, {80, 60});
  const auto by_color = measure(wall(), Stream::color, {77, 60});
  ASSERT_TRUE(by_color);
  EXPECT_NEAR((by_color->position_m - by_depth->position_m).norm(), 0.0, 1e-9) << "3 px of parallax at 1 m";
}

TEST(Measurement, WhereSurfacesHideEachOtherTheNearerIsSeen) {
  LiveFrame live = wall();
  for (int v = 0; v < 120; ++v) {
    for (int u = 70; u < 90; ++u) live.frame.depth(u, v) = 500;
  }
  EXPECT_NEAR(measure(live, Stream::color, {74, 60})->position_m.z(), 0.5, 0.01);
}

TEST(Measurement, HolesAndPixelsOutsideGiveNothing) {
  LiveFrame live = wall();
  for (int v = 50; v < 70; ++v) {
    for (int u = 70; u < 90; ++u) live.frame.depth(u, v) = no_depth;
  }
  EXPECT_FALSE(measure(live, Stream::depth, {80, 60}));
  EXPECT_FALSE(measure(live, Stream::depth, {-5, 60}));
  EXPECT_FALSE(measure(live, Stream::depth, {1e300, 60}));
  EXPECT_FALSE(measure(live, Stream::depth, {std::nan(""), 60}));
  EXPECT_TRUE(measure(live, Stream::depth, {0, 0})) << "the corner has its few neighbours";
  live.frame.depth(30, 30) = no_depth;
  EXPECT_TRUE(measure(live, Stream::depth, {30, 30})) << "one pixel among many";
}

}  // namespace
}  // namespace rva
