#include "views/planar_patches.hpp"

#include <gtest/gtest.h>

#include "tests/views/box_room.hpp"

namespace rva {
namespace {

// A plane in space is one in disparity, exactly: that is why surfaces are fitted there.
TEST(PlanarPatches, FollowATiltedFloorToTheLastDigit) {
  const DepthView view = test::view_of({{test::box(-5, 5, 0.25, 0.3, -5, 50)}}, test::pose(0, 0, 10, 25));
  const PlanarPatches patches(view, 8, 8);
  int compared = 0;
  for (int v = 100; v < 230; ++v) {
    for (int u = 10; u < 410; ++u) {
      const PlanarPatch* patch = patches.find<double>(u, v);
      ASSERT_NE(patch, nullptr) << u << " " << v;
      EXPECT_NEAR(patches.disparity_px<double>(*patch, u, v), view.disparity_px(u, v), 1e-3);
      ++compared;
    }
  }
  EXPECT_GT(compared, 50000);
}

TEST(PlanarPatches, HaveNothingToSayAboutEdgesAndHoles) {
  DepthView view = test::view_of({{test::box(-5, 5, -5, 5, 1.0, 1.1), test::box(-5, 0.0, -5, 5, 0.7, 0.8)}},
                                 test::pose(0, 0, 0, 0));
  const PlanarPatches edge(view, 8, 8);
  EXPECT_EQ(edge.find(211.0, 100.0), nullptr) << "where the nearer box ends";
  EXPECT_NE(edge.find(180.0, 100.0), nullptr);
  for (int v = 0; v < 240; ++v) {
    for (int u = 0; u < 100; ++u) view.disparity_px(u, v) = 0.0F;
  }
  const PlanarPatches holes(view, 8, 8);
  EXPECT_EQ(holes.find(50.0, 100.0), nullptr);
  EXPECT_NE(holes.find(120.0, 100.0), nullptr);
  for (const double outside : {-1.0, 1e30, -1e30, std::numeric_limits<double>::quiet_NaN()})
    EXPECT_EQ(holes.find<double>(outside, 100), nullptr);
}

}  // namespace
}  // namespace rva
