#include "detect/calibrated/unreliable_pixels.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/detect/calibrated/noisy_captures.hpp"

namespace rva {
namespace {

test::NoisyCapture with_hole(test::NoisyCapture capture) {
  capture.disparity_px = [](int u, int v) { return u >= 200 && u < 210 && v >= 100 && v < 110 ? 0.0 : 25.0; };
  return capture;
}

Mask unsure_of(const DepthStatistics& before, const DepthStatistics& after) {
  return unreliable_pixels(disparity_change(before, after, test::stereo));
}

double share_set(const Mask& mask) {
  return static_cast<double>(std::ranges::count(mask.pixels(), mask_set)) / static_cast<double>(mask.size());
}

TEST(UnreliablePixels, LieAroundHoles) {
  const test::NoisyCapture capture = with_hole({});
  const Mask unreliable = unsure_of(capture.take(1), capture.take(2));
  EXPECT_EQ(unreliable(205, 105), mask_set);
  EXPECT_EQ(unreliable(195, 105), mask_set);
  EXPECT_EQ(unreliable(185, 105), 0);
}

TEST(UnreliablePixels, LackEightOfThePixelsAround) {
  for (const int missing : {7, 8}) {
    test::NoisyCapture capture;
    capture.disparity_px = [&](int u, int v) {
      return v == 100 && u >= 200 && u < 200 + missing ? 0.0 : 25.0;
    };
    EXPECT_EQ(unsure_of(capture.take(1), capture.take(2))(203, 106), missing > 7 ? mask_set : 0) << missing;
  }
}

TEST(UnreliablePixels, DoNotLieAroundHolesThatDebrisMade) {
  const test::NoisyCapture clean;
  const Mask unreliable = unsure_of(clean.take(1), with_hole(clean).take(2));
  EXPECT_EQ(unreliable(195, 105), 0);
  EXPECT_EQ(unsure_of(with_hole(clean).take(1), clean.take(2))(195, 105), 0) << "nor once it is gone";
}

TEST(UnreliablePixels, VaryMoreThanOthers) {
  test::NoisyCapture capture;
  capture.disparity_px = [flicker = 0](int u, int /*v*/) mutable {
    return u < 60 ? 25.0 + 0.3 * (flicker++ / (60 * 240) % 2) : 25.0;  // every other frame
  };
  const Mask unreliable = unsure_of(capture.take(1), capture.take(2));
  EXPECT_EQ(unreliable(30, 120), mask_set);
  EXPECT_EQ(unreliable(100, 120), 0);
  EXPECT_NEAR(share_set(unreliable), 60.0 / 424.0, 0.03);
}

TEST(UnreliablePixels, OfSingleFramesAreThoseAroundHoles) {
  test::NoisyCapture capture = with_hole({});
  capture.frames = 1;
  const Mask unreliable = unsure_of(capture.take(1), capture.take(2));
  EXPECT_EQ(unreliable(195, 105), mask_set);
  EXPECT_EQ(unreliable(100, 105), 0);
}

}  // namespace
}  // namespace rva
