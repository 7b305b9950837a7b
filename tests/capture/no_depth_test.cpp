#include "capture/no_depth.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace rva {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A slope from 0.8 to 1.2 m, in millimetres, of which a block has another value.
DepthImage slope_with(std::uint16_t value, int side = 12) {
  DepthImage image(100, 80);
  for (int v = 0; v < 80; ++v) {
    for (int u = 0; u < 100; ++u) image(u, v) = static_cast<std::uint16_t>(800 + 4 * u);
  }
  for (int v = 20; v < 20 + side; ++v) {
    for (int u = 30; u < 30 + side; ++u) image(u, v) = value;
  }
  return image;
}

std::size_t holes(const DepthImage& image, const NoDepthValues& values, const DepthImage& first) {
  DepthImage cleared = image;
  values.clear(cleared, [&] { return first; });
  return static_cast<std::size_t>(std::ranges::count(cleared.pixels(), no_depth));
}

TEST(NoDepthValues, TheLargestValueIsNone) {
  DepthImage image = slope_with(65535);
  const NoDepthValues values({}, 0.001);
  EXPECT_EQ(holes(image, values, image), 144U);
  EXPECT_THAT(values.notes([&] { return image; }),
              ElementsAre(HasSubstr("65535 stands for no measurement (1.8 %")));
  EXPECT_EQ(holes(slope_with(65535, 1), values, image), 1U) << "in later frames, too";
}

TEST(NoDepthValues, OthersAreRecognisedFarBeyondTheRest) {
  for (const std::uint16_t value :
       std::initializer_list<std::uint16_t>{10000, 4095, 8191, 32767, 55537, 65534}) {
    DepthImage image = slope_with(value);
    EXPECT_EQ(holes(image, NoDepthValues({}, 0.001), image), 144U) << value;
  }
}

TEST(NoDepthValues, DepthIsNotTakenForNone) {
  const auto kept = [](const DepthImage& image, double unit_m) {
    EXPECT_EQ(holes(image, NoDepthValues({}, unit_m), image), 0U);
  };
  kept(slope_with(1900), 0.001);            // a wall behind a hole
  kept(slope_with(5123), 0.001);            // far, but no value that a tool writes
  kept(slope_with(10000), 0.0001);          // at one metre
  kept(slope_with(10000, 2), 0.001);        // four pixels
  kept(DepthImage(100, 80, 10000), 0.001);  // nothing else in the image
}

TEST(NoDepthValues, StatedOnesCountWhateverTheyAre) {
  DepthImage image = slope_with(5123);
  EXPECT_EQ(holes(image, NoDepthValues({5123}, 0.001), image), 144U);
}

TEST(NoDepthValues, ASaturatedPixelBesideHolesChangesNothingAboutThem) {
  DepthImage image = slope_with(65535);
  EXPECT_FALSE(NoDepthValues({}, 0.001).are_zero([&] { return image; }));
  image(0, 0) = 0;
  EXPECT_TRUE(NoDepthValues({}, 0.001).are_zero([&] { return image; }));
  EXPECT_TRUE(NoDepthValues({}, 0.001).are_zero([] { return slope_with(900); }));
}

TEST(NoDepthValues, SayNothingWhereThereAreNone) {
  DepthImage image = slope_with(0);
  EXPECT_THAT(NoDepthValues({}, 0.001).notes([&] { return image; }), IsEmpty());
}

TEST(NoDepth, OfFloatingPointImages) {
  Image<float> metres(8, 1, 1.0F);
  metres[0] = std::nanf("");
  metres[1] = -1.0F;
  metres[2] = 0.0F;
  metres[3] = std::numeric_limits<float>::infinity();
  metres[4] = 70.0F;  // does not fit
  metres[5] = 0.0004F;
  metres[6] = 1.2346F;
  const DepthImage depth = depth_from_metres(metres, 0.001);
  EXPECT_THAT(std::vector(depth.pixels().begin(), depth.pixels().end()),
              ElementsAre(0, 0, 0, 0, 0, 0, 1235, 1000));
}

}  // namespace
}  // namespace rva
