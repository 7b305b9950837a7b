#include "detect/findings/drawing.hpp"

#include <gtest/gtest.h>

#include <algorithm>

namespace rva {
namespace {

Finding square_at(int left, int top, int side, int width) {
  Finding finding;
  finding.id = 1;
  finding.box = {left, top, side, side};
  for (int v = top; v < top + side; ++v) {
    for (int u = left; u < left + side; ++u)
      finding.pixels.push_back(static_cast<std::uint32_t>(v * width + u));
  }
  return finding;
}

CaptureInfo two_imagers(double offset_m) {
  CaptureInfo capture;
  capture.depth = {100, 80, 50.0, 50.0, 49.5, 39.5};
  capture.color = Intrinsics{200, 160, 100.0, 100.0, 99.5, 79.5};
  capture.color_from_depth = Transform::Identity();
  capture.color_from_depth->translation().x() = offset_m;
  return capture;
}

TEST(BoxOnColor, FollowsTheOffsetBetweenTheImagers) {
  const Finding finding = square_at(40, 30, 5, 100);
  const ColorImage color(200, 160);
  for (const float depth_m : {0.5F, 1.0F, 2.0F}) {
    const Image<float> final_m(100, 80, depth_m);
    const auto box = box_on_color(finding, final_m, two_imagers(0.05), color);
    ASSERT_TRUE(box);
    // Twice the focal length, so twice the size; the nearer, the larger the shift.
    EXPECT_NEAR(box->x, (40 - 49.5) * 2 + 99.5 + 0.05 * 100 / depth_m, 1.0);
    EXPECT_NEAR(box->y, (30 - 39.5) * 2 + 79.5, 1.0);
    EXPECT_NEAR(box->width, 9, 1);
  }
}

TEST(BoxOnColor, IsNoneOutsideTheView) {
  EXPECT_FALSE(box_on_color(square_at(40, 30, 5, 100), Image<float>(100, 80, 1.0F), two_imagers(5.0),
                            ColorImage(200, 160)));
  EXPECT_FALSE(
      box_on_color(square_at(40, 30, 5, 100), Image<float>(100, 80), two_imagers(0.0), ColorImage(200, 160)));
}

TEST(BoxOnColor, ScalesWhereNothingIsKnownOfTheColorImager) {
  CaptureInfo capture = two_imagers(0.05);
  capture.color_from_depth.reset();
  const auto box =
      box_on_color(square_at(40, 30, 5, 100), Image<float>(100, 80, 1.0F), capture, ColorImage(200, 160));
  EXPECT_EQ(box, (Box{80, 60, 10, 10}));
}

TEST(Overlay, DrawsGreenAndCountsWhatIsOutside) {
  const Image<float> final_m(100, 80, 1.0F);
  const std::vector<Finding> findings{square_at(40, 30, 5, 100)};
  const Overlay inside = draw_on_color(ColorImage(200, 160), findings, final_m, two_imagers(0.05));
  EXPECT_EQ(inside.outside, 0U);
  EXPECT_GT(std::ranges::count(inside.picture.pixels(), Rgb{0, 255, 0}), 20);
  const Overlay outside = draw_on_color(ColorImage(200, 160), findings, final_m, two_imagers(5.0));
  EXPECT_EQ(outside.outside, 1U);
  EXPECT_EQ(std::ranges::count(outside.picture.pixels(), Rgb{0, 255, 0}), 0);
}

// A finding in every corner, of any size: drawing stays inside the picture.
TEST(Overlay, SurvivesFindingsAtTheBorder) {
  for (const int side : {1, 80}) {
    for (const auto& [left, top] :
         {std::pair{0, 0}, {100 - side, 0}, {0, 80 - side}, {100 - side, 80 - side}}) {
      const std::vector<Finding> findings{square_at(left, top, side, 100)};
      const ColorImage picture = draw_on_depth(Image<float>(100, 80, 1.0F), findings);
      EXPECT_GT(picture.width(), 100) << "a legend is at the right";
      EXPECT_GE(picture.height(), 80);
      EXPECT_EQ(picture(picture.width() - 1, 0), (Rgb{255, 255, 255}));
    }
  }
}

TEST(ChangedPoints, AreGreenOnGreyWhereTheColorImagerSeesThem) {
  ColorImage color(200, 160);
  for (Rgb& pixel : color.pixels()) pixel = {200, 40, 90};
  Mask changed(100, 80);
  changed(40, 30) = mask_set;
  changed(10, 10) = mask_set;  // without a depth it has no position
  Image<float> final_m(100, 80);
  final_m(40, 30) = 0.5F;
  final_m(50, 50) = 0.5F;
  const ColorImage drawn = draw_changed_points(color, changed, final_m, two_imagers(0.05));
  const Rgb green{0, 255, 0};
  EXPECT_EQ(std::ranges::count(drawn.pixels(), green), 1);
  EXPECT_EQ(drawn(91, 61), green) << "(40 - 49.5) * 2 + 99.5 + 0.05 * 100 / 0.5, and rounded";
  const Rgb grey = drawn(0, 0);
  EXPECT_EQ(grey.r, grey.g);
  EXPECT_EQ(grey.g, grey.b);
  EXPECT_EQ(std::ranges::count(drawn.pixels(), grey), 200 * 160 - 1);
}

TEST(ChangedPoints, AreScaledWhereNothingIsKnownOfTheColorImager) {
  CaptureInfo capture = two_imagers(0.05);
  capture.color_from_depth.reset();
  Mask changed(100, 80);
  changed(40, 30) = mask_set;
  const ColorImage drawn =
      draw_changed_points(ColorImage(200, 160), changed, Image<float>(100, 80, 1.0F), capture);
  EXPECT_EQ(drawn(80, 60), (Rgb{0, 255, 0}));
}

}  // namespace
}  // namespace rva
