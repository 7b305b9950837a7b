#include "infrared/reference_surface.hpp"

#include <gtest/gtest.h>

#include "tests/infrared/dotted_wall.hpp"

namespace rva {
namespace {

TEST(ReferenceSurface, FillsHolesFromTheNearestPixel) {
  const Intrinsics camera{.width = 8, .height = 4, .fx = 10.0, .fy = 10.0, .cx = 3.5, .cy = 1.5};
  Image<float> disparity(8, 4, 20.0F);
  for (int v = 0; v < 4; ++v) {
    for (int u = 4; u < 8; ++u) disparity(u, v) = 40.0F;
  }
  disparity(1, 1) = disparity(6, 2) = 0.0F;
  const ReferenceSurface surface = reference_surface(camera, disparity, {.focal_baseline_m_px = 20.0});
  EXPECT_FLOAT_EQ(surface.inverse_depth_per_m(1, 1), 1.0F);
  EXPECT_FLOAT_EQ(surface.inverse_depth_per_m(6, 2), 2.0F);
}

TEST(ReferenceSurface, OfNothingIsEmpty) {
  EXPECT_TRUE(reference_surface(test::wall_camera, Image<float>(320, 240), {.focal_baseline_m_px = 20.0})
                  .inverse_depth_per_m.empty());
}

TEST(Warp, IsTheSameAsProjection) {
  const ReferenceSurface surface = test::wall_surface();
  Transform view_from_reference = test::turned({0.01, -0.02, 0.005});
  view_from_reference.translation() = Eigen::Vector3d(0.002, -0.001, 0.003);
  Image<float> column(320, 240);
  Image<float> row(320, 240);
  for (int v = 0; v < 240; ++v) {
    for (int u = 0; u < 320; ++u) {
      column(u, v) = static_cast<float>(u);
      row(u, v) = static_cast<float>(v);
    }
  }
  const Warp warp(surface, view_from_reference);
  const Image<float> columns = warp.image(column);
  const Image<float> rows = warp.image(row);
  for (const auto& [u, v] : {std::pair(160, 120), std::pair(40, 200), std::pair(290, 30)}) {
    const Eigen::Vector3d point = view_from_reference * test::wall_camera.deproject({u, v}, test::wall_m);
    const Eigen::Vector2d expected = test::wall_camera.project(point);
    constexpr double rounding_px = 1e-3;
    EXPECT_NEAR(columns(u, v), expected.x(), rounding_px);
    EXPECT_NEAR(rows(u, v), expected.y(), rounding_px);
  }
}

TEST(Warp, OutsideTheViewNothingIsClear) {
  const Warp warp(test::wall_surface(), test::turned({0.0, 0.1, 0.0}));
  const Mask clear = warp.clear_of(Mask(320, 240));
  EXPECT_NE(clear(40, 120), 0);
  EXPECT_EQ(clear(310, 120), 0);
  EXPECT_TRUE(warp.inside(40, 120, 6.0F));
  EXPECT_FALSE(warp.inside(310, 120, 6.0F));
}

}  // namespace
}  // namespace rva
