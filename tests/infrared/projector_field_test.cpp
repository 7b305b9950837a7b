#include "infrared/projector_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "infrared/dot_mask.hpp"
#include "tests/infrared/dotted_wall.hpp"

namespace rva {
namespace {

/// Pixels [left, right) by [top, bottom).
struct Area {
  int left = 0;
  int top = 0;
  int right = 0;
  int bottom = 0;
};

/// A wall that the projector does not light in one area.
Image<float> lit_but_in(const Area& dark, double other_light = 0.3) {
  Image<float> grey = test::wall_seen(Eigen::Vector3d::Zero(), 1);
  const Image<float> unlit =
      test::wall_seen(Eigen::Vector3d::Zero(), 2, {.noise = 0.1, .background = other_light, .dots = 0.0});
  for (int v = dark.top; v < dark.bottom; ++v) {
    for (int u = dark.left; u < dark.right; ++u) grey(u, v) = unlit(u, v);
  }
  return grey;
}

Mask beyond(const Image<float>& grey) {
  constexpr int beside_px = 6;
  const Image<float> log_image = log_grey(grey);
  return beyond_projector(log_image, dot_mask(log_image), beside_px);
}

std::ptrdiff_t set_pixels(const Mask& mask) { return std::ranges::count(mask.pixels(), mask_set); }

constexpr int width = 320;
constexpr int height = 240;

TEST(ProjectorField, ThatFillsTheImageLeavesNothingBeyond) {
  EXPECT_EQ(set_pixels(beyond(lit_but_in({}))), 0);
}

TEST(ProjectorField, EndsWhereTheDotsEnd) {
  for (const int strip_px : {12, 20, 80}) {
    const Mask mask = beyond(lit_but_in({.left = width - strip_px, .right = width, .bottom = height}));
    for (int v = 0; v < height; ++v) {
      EXPECT_EQ(mask(width - 1, v), mask_set) << strip_px << ' ' << v;
      EXPECT_EQ(mask(width - strip_px + 4, v), mask_set) << strip_px << ' ' << v;
      EXPECT_EQ(mask(width - strip_px - 14, v), 0) << strip_px << ' ' << v;
    }
  }
}

TEST(ProjectorField, MayEndAtAnyBorder) {
  EXPECT_EQ(beyond(lit_but_in({.right = width, .bottom = 14}))(160, 2), mask_set);
  EXPECT_EQ(beyond(lit_but_in({.top = height - 14, .right = width, .bottom = height}))(160, height - 3),
            mask_set);
  EXPECT_EQ(beyond(lit_but_in({.right = 14, .bottom = height}))(2, 120), mask_set);
}

TEST(ProjectorField, AHoleWithinItIsNotBeyond) {
  const Image<float> grey = lit_but_in({.left = 120, .top = 80, .right = 200, .bottom = 160});
  EXPECT_EQ(set_pixels(beyond(grey)), 0);
  EXPECT_EQ(without_dots(dot_mask(log_grey(grey)))(160, 120), mask_set);
}

TEST(ProjectorField, OtherLightIsLight) {
  const Area strip{.left = width - 40, .right = width, .bottom = height};
  EXPECT_EQ(set_pixels(beyond(lit_but_in(strip, 40.0))), 0);
  EXPECT_GT(set_pixels(beyond(lit_but_in(strip, 2.0))), 0);
}

}  // namespace
}  // namespace rva
