#include "depth/colorize.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

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
  for (const ColorMap map : {ColorMap::turbo, ColorMap::jet}) {
    const ColorImage image = colorize(values, {0.0F, 1.0F}, map);
    EXPECT_GT(image(0, 0).b, 100);
    EXPECT_GT(image(0, 0).b, image(0, 0).r);
    EXPECT_GT(image(1, 0).r, 100);
    EXPECT_GT(image(1, 0).r, 10 * image(1, 0).b);
    EXPECT_EQ(image(2, 0), image(0, 0));  // beyond the scale: its end
    EXPECT_EQ(image(3, 0), image(1, 0));
    EXPECT_EQ(image(4, 0), Rgb{});
  }
}

// Equal steps of the value must look about equally large. The largest difference between neighbouring colours
// of turbo, summed over the components, is less than that of jet.
TEST(Colorize, HasNoColorThatLooksLikeAnEdge) {
  Image<float> values(33, 1);
  for (int u = 0; u < 33; ++u) values(u, 0) = static_cast<float>(u) / 32.0F;
  const auto brightness = [](const Rgb& color) {
    return 0.299 * color.r + 0.587 * color.g + 0.114 * color.b;
  };
  const auto most = [&](ColorMap map) {
    const ColorImage image = colorize(values, {0.0F, 1.0F}, map);
    double step = 0.0;
    for (int u = 1; u < 33; ++u)
      step = std::max(step, std::abs(brightness(image(u, 0)) - brightness(image(u - 1, 0))));
    return step;
  };
  EXPECT_LT(most(ColorMap::turbo), most(ColorMap::jet));
}

TEST(Legend, StandsBesideTheImage) {
  ColorImage image(320, 240);
  for (std::size_t i = 0; i < image.size(); ++i) image[i] = {static_cast<std::uint8_t>(i % 251), 2, 3};
  const ColorImage with = with_legend(image, {0.0F, 2.0F}, "depth\n(m)");
  EXPECT_EQ(with.height(), 240);
  EXPECT_GT(with.width(), 320);
  for (int v = 0; v < 240; ++v) {
    for (int u = 0; u < 320; ++u) ASSERT_EQ(with(u, v), image(u, v)) << "pixels stay where they are";
  }
}

TEST(Legend, StandsBesideAnImageOfAnySize) {
  for (const auto& [width, height] : {std::pair{1, 1}, {8, 8}, {64, 17}, {2000, 2}, {3, 900}}) {
    const ColorImage with = with_legend(ColorImage(width, height, Rgb{1, 2, 3}), {0.0F, 2.0F}, "mm");
    EXPECT_GE(with.height(), height);
    EXPECT_GT(with.width(), width);
    EXPECT_EQ(with(width - 1, height - 1), (Rgb{1, 2, 3}));
  }
}

// Nothing that is written may be cut off: a wider title or wider labels make a wider picture, with a white
// margin.
TEST(Legend, HasRoomForItsText) {
  const ColorImage image(64, 48, Rgb{1, 2, 3});
  for (const ColorScale scale :
       {ColorScale{0.0F, 2.0F}, {0.0F, 1e-4F}, {12345.0F, 98765.0F}, {-3.5F, -3.49F}}) {
    for (const char* title : {"mm", "a title that is much wider than the bar\n(mm)"}) {
      const ColorImage with = with_legend(image, scale, title);
      bool black = false;
      for (int v = 0; v < with.height(); ++v) {
        EXPECT_EQ(with(with.width() - 1, v), (Rgb{255, 255, 255})) << title;
        for (int u = 64; u < with.width(); ++u) black = black || with(u, v) == Rgb{};
      }
      EXPECT_TRUE(black) << "something is written";
    }
  }
}

TEST(ColorScale, CoversMostValuesWithRoundEnds) {
  Image<float> values(1000, 1);
  for (int u = 0; u < 1000; ++u) values(u, 0) = 0.001F * static_cast<float>(u);
  values(999, 0) = 1e6F;  // an outlier must not stretch the colours
  EXPECT_FLOAT_EQ(scale_from_zero(values).high, 1.0F);
  const ColorScale scale = scale_of_depth(values);
  EXPECT_FLOAT_EQ(scale.low, 0.0F);
  EXPECT_FLOAT_EQ(scale.high, 0.9F);
}

TEST(ColorScale, SurvivesAnEmptyAndAFlatImage) {
  for (const float level : {nan, 0.0F, 2.0F, 6000.0F}) {
    const Image<float> flat(3, 3, level);
    EXPECT_LT(scale_from_zero(flat).low, scale_from_zero(flat).high);
    EXPECT_LT(scale_of_depth(flat).low, scale_of_depth(flat).high);
  }
}

}  // namespace
}  // namespace rva
