#include "classify/surroundings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace rva {
namespace {

TEST(Surroundings, AreTwiceAsWideAsTheBoxAboutItsMiddle) {
  EXPECT_EQ(surroundings_of({100, 200, 40, 30}, 848, 480), (Box{80, 175, 80, 80}));
  EXPECT_EQ(surroundings_of({100, 200, 4, 2}, 848, 480), (Box{86, 185, 32, 32})) << "no fewer than 32 pixels";
}

TEST(Surroundings, LieWithinThePictureAndContainWhatItShowsOfTheBox) {
  std::mt19937 random(1);
  const auto draw = [&](int least, int most) { return std::uniform_int_distribution(least, most)(random); };
  for (int trial = 0; trial < 20'000; ++trial) {
    const int width = draw(1, 300);
    const int height = draw(1, 300);
    Box box;
    box.x = draw(-20, width + 20);
    box.y = draw(-20, height + 20);
    box.width = draw(1, 200);
    box.height = draw(1, 200);
    const Box part = surroundings_of(box, width, height);
    ASSERT_GE(part.x, 0);
    ASSERT_GE(part.y, 0);
    ASSERT_GE(part.width, 1);
    ASSERT_GE(part.height, 1);
    ASSERT_LE(part.x + part.width, width);
    ASSERT_LE(part.y + part.height, height);
    const int from_x = std::clamp(box.x, 0, width);
    const int until_x = std::clamp(box.x + box.width, 0, width);
    if (from_x >= until_x) continue;
    EXPECT_LE(part.x, from_x);
    EXPECT_GE(part.x + part.width, until_x);
  }
}

TEST(Surroundings, AreCutOutPixelByPixel) {
  ColorImage picture(7, 5);
  for (int v = 0; v < 5; ++v)
    for (int u = 0; u < 7; ++u)
      picture(u, v) = {static_cast<std::uint8_t>(u), static_cast<std::uint8_t>(v), 9};
  const ColorImage part = part_of(picture, {2, 1, 4, 3});
  ASSERT_EQ(part.width(), 4);
  ASSERT_EQ(part.height(), 3);
  for (int v = 0; v < 3; ++v)
    for (int u = 0; u < 4; ++u) EXPECT_EQ(part(u, v), picture(u + 2, v + 1));
}

}  // namespace
}  // namespace rva
