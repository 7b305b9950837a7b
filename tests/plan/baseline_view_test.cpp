#include "plan/baseline_view.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "tests/plan/planned_floor.hpp"

namespace rva {
namespace {

using test::clean_floor;
using test::floor_camera;

// The camera stands 0.1 m to the right after the work: the floor shifts by 50 pixels to the left.
Detection shifted_floor() {
  Detection detection = clean_floor();
  detection.findings.final_from_initial.translation() = Eigen::Vector3d(-0.1, 0.0, 0.0);
  return detection;
}

TEST(BaselineView, OfACameraThatStoodStillHasTheSamePixels) {
  const BaselineView view(clean_floor(), {floor_camera(), floor_camera()});
  EXPECT_EQ(view.at({12, 34}, std::nullopt), Eigen::Vector2d(12, 34));
  EXPECT_EQ(view.level_mm({12, 34}), 4.0);
}

TEST(BaselineView, FollowsTheSurfaceWhereTheCameraMoved) {
  const BaselineView view(shifted_floor(), {floor_camera(), floor_camera()});
  EXPECT_FALSE(view.at({12, 34}, std::nullopt));
  EXPECT_TRUE(view.at({12, 34}, 1.0)->isApprox(Eigen::Vector2d(62, 34), 1e-9));
}

TEST(BaselineView, WhatTheFinalViewDoesNotShowWasNotInspected) {
  const BaselineView view(shifted_floor(), {floor_camera(), floor_camera()});
  EXPECT_FALSE(view.level_mm({20, 60}));
  EXPECT_EQ(view.level_mm({120, 60}), 4.0);
}

TEST(BaselineView, OfAMethodWithoutALevelInspectsWhatItMeasures) {
  Detection detection = clean_floor();
  detection.level_of_detection.reset();
  for (int v = 0; v < test::floor_height; ++v) {
    for (int u = 0; u < 50; ++u) detection.final_m(u, v) = 0.0F;
  }
  detection.left_out = Mask(test::floor_width, test::floor_height);
  for (int v = 0; v < test::floor_height; ++v) {
    for (int u = 150; u < test::floor_width; ++u) detection.left_out(u, v) = mask_set;
  }
  const BaselineView view(detection, {floor_camera(), floor_camera()});
  EXPECT_FALSE(view.level_mm({20, 60}));
  EXPECT_EQ(view.level_mm({100, 60}), 0.0);
  EXPECT_FALSE(view.level_mm({180, 60}));
}

}  // namespace
}  // namespace rva
