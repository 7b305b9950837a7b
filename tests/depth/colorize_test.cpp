#include "depth/colorize.hpp"

#include <gtest/gtest.h>

#include <limits>

namespace rva {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

TEST(Colorize, RunsFromBlueToRed) {
  Image<float> values(5, 1);
  values(0, 0) = 0.0F;
  values(1, 0) = 1.0F;
  values(2, 0) = -5.0F;
  values(3, 0) = 50.0F;
  values(4, 0) = nan;
  const ColorImage image = colorize(values, {0.0F, 1.0F});
  EXPECT_GT(image(0, 0).b, 100);
  EXPECT_EQ(image(0, 0).r, 0);
  EXPECT_GT(image(1, 0).r, 100);
  EXPECT_EQ(image(1, 0).b, 0);
  EXPECT_EQ(image(2, 0), image(0, 0));  // beyond the scale: its end
  EXPECT_EQ(image(3, 0), image(1, 0));
  EXPECT_EQ(image(4, 0), Rgb{});
}

TEST(ScaleBar, StandsBesideTheImage) {
  const ColorImage image(320, 240, Rgb{1, 2, 3});
  const ColorImage with_bar = with_scale_bar(image, {0.0F, 2.0F}, "mm");
  EXPECT_EQ(with_bar.height(), 240);
  EXPECT_GT(with_bar.width(), 320);
  EXPECT_EQ(with_bar(319, 239), (Rgb{1, 2, 3}));
}

TEST(ScaleBar, StandsBesideAnImageOfAnySize) {
  for (const auto& [width, height] : {std::pair{1, 1}, {8, 8}, {64, 17}, {2000, 2}, {3, 900}}) {
    const ColorImage with_bar = with_scale_bar(ColorImage(width, height, Rgb{1, 2, 3}), {0.0F, 2.0F}, "mm");
    EXPECT_GE(with_bar.height(), height);
    EXPECT_GT(with_bar.width(), width);
    EXPECT_EQ(with_bar(width - 1, height - 1), (Rgb{1, 2, 3}));
  }
}

TEST(ColorScale, CoversAlmostAllValuesWithRoundEnds) {
  Image<float> values(1000, 1);
  for (int u = 0; u < 1000; ++u) values(u, 0) = 0.001F * static_cast<float>(u);
  values(999, 0) = 1e6F;  // an outlier must not stretch the colours
  EXPECT_FLOAT_EQ(scale_from_zero(values).high, 1.0F);
  const ColorScale scale = scale_around(values);
  EXPECT_LE(scale.low, 0.01F);
  EXPECT_GE(scale.high, 0.99F);
  EXPECT_LT(scale.high, 1.5F);
}

TEST(ColorScale, SurvivesAnEmptyAndAFlatImage) {
  EXPECT_LT(scale_from_zero(Image<float>(3, 3, nan)).low, scale_from_zero(Image<float>(3, 3, nan)).high);
  for (const float level : {nan, 0.0F, 2.0F, 5e6F}) {
    const ColorScale scale = scale_around(Image<float>(3, 3, level));
    EXPECT_LT(scale.low, scale.high);
  }
}

}  // namespace
}  // namespace rva
