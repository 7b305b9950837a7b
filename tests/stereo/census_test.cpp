#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <string_view>

#include "stereo/block_matching.hpp"
#include "tests/stereo/random_images.hpp"

namespace rva {
namespace {

/// The star, drawn: bit 0 is `a`, bit 15 is `p`, the pixel itself is in the middle.
constexpr std::array<std::string_view, 7> star{"..m..o.",  //
                                               "...g..l",  //
                                               "i.a.b..",  //
                                               ".e...f.",  //
                                               "..c.d.j",  //
                                               "k..h...",  //
                                               ".p..n.."};

int pixel_or_nearest(const InfraredImage& image, int u, int v) {
  return image(std::clamp(u, 0, image.width() - 1), std::clamp(v, 0, image.height() - 1));
}

std::uint16_t slow_census(const InfraredImage& image, int u, int v, int threshold) {
  int bits = 0;
  for (std::size_t row = 0; row < star.size(); ++row) {
    for (std::size_t column = 0; column < star[row].size(); ++column) {
      const char letter = star[row][column];
      if (letter == '.') continue;
      const int other =
          pixel_or_nearest(image, u - 3 + static_cast<int>(column), v - 3 + static_cast<int>(row));
      const int difference = other - image(u, v);
      if (difference > threshold) bits |= 1 << (letter - 'a');
    }
  }
  return static_cast<std::uint16_t>(bits);
}

void expect_census(const InfraredImage& image, int threshold) {
  const Image<std::uint16_t> bits = census(image, threshold);
  ASSERT_TRUE(bits.same_size(image));
  for (int v = 0; v < image.height(); ++v) {
    for (int u = 0; u < image.width(); ++u)
      ASSERT_EQ(bits(u, v), slow_census(image, u, v, threshold)) << u << " " << v;
  }
}

TEST(Census, AgreesWithTheDefinitionUpToTheBorders) {
  for (const int threshold : {0, 20, 500}) expect_census(test::white_image(61, 37, 1), threshold);
}

TEST(Census, ImagesMayBeSmallerThanTheStar) {
  for (const auto& [width, height] : {std::pair{1, 1}, {2, 5}, {7, 1}, {3, 3}})
    expect_census(test::white_image(width, height, 2), 20);
}

TEST(Census, OnlyMoreThanTheThresholdCounts) {
  InfraredImage image(9, 9, 100);
  image(6, 4) = 120;
  EXPECT_EQ(census(image, 20)(4, 4), 0);
  image(6, 4) = 121;
  EXPECT_EQ(census(image, 20)(4, 4), 1 << 5);
}

TEST(Census, BrightnessOfTheWholeImageDoesNotMatter) {
  InfraredImage image = test::white_image(40, 30, 3);
  for (std::uint16_t& pixel : image.pixels()) pixel = static_cast<std::uint16_t>(pixel / 2);
  InfraredImage brighter = image;
  for (std::uint16_t& pixel : brighter.pixels()) pixel = static_cast<std::uint16_t>(pixel + 400);
  EXPECT_EQ(census(image, 20), census(brighter, 20));
}

TEST(Census, FlatIsZero) {
  EXPECT_EQ(census(InfraredImage(20, 10, 500), 0), Image<std::uint16_t>(20, 10, 0));
  EXPECT_EQ(census(test::noisy(InfraredImage(20, 10, 500), 2.0, 4), 20), Image<std::uint16_t>(20, 10, 0));
}

}  // namespace
}  // namespace rva
