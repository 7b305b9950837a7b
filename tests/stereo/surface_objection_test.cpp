#include "stereo/surface_objection.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "tests/stereo/dithered_pairs.hpp"

namespace rva {
namespace {

constexpr double speckle = 0.12;

// A strip came 50 mm nearer: 1.7 pixels of disparity.
const test::Plane empty{};
const test::Plane with_strip{.depth_m = 0.8, .slope = 0.0, .step_m = 0.05, .step_x_m = 0.05, .end_x_m = 0.1};

/// What was there on either side, and what the depth images of either side claim.
struct Sides {
  test::Plane before;
  test::Plane after;
  test::Plane claimed_before;
  test::Plane claimed_after;
};

SurfaceObjection objection_of(const Sides& sides, std::size_t captures, std::uint64_t seed) {
  std::vector<StereoView> before = test::dithered_pairs(sides.before, captures, speckle, seed);
  std::vector<StereoView> after = test::dithered_pairs(sides.after, captures, speckle, seed + 100);
  return surface_objection(test::off_by(test::true_disparity(sides.claimed_before), 0.0F),
                           test::off_by(test::true_disparity(sides.claimed_after), 0.0F), test::pair_stereo,
                           before, after);
}

// In the middle of the strip, where all of it is judged.
double mean_in_strip(const SurfaceObjection& objection) {
  double sum = 0.0;
  int count = 0;
  for (int v = 20; v < test::pair_camera.height - 20; ++v) {
    for (int u = 155; u < 165; ++u, ++count) {
      EXPECT_EQ(objection.judged(u, v), mask_set);
      sum += static_cast<double>(objection.variances(u, v));
    }
  }
  return sum / count;
}

TEST(SurfaceObjection, BothSidesObjectToWhatTrulyChanged) {
  for (const std::size_t captures : {std::size_t{1}, std::size_t{8}}) {
    EXPECT_GT(mean_in_strip(objection_of({empty, with_strip, empty, with_strip}, captures, 1)), 12.0)
        << captures;
    EXPECT_GT(mean_in_strip(objection_of({with_strip, empty, with_strip, empty}, captures, 2)), 12.0)
        << captures;
  }
}

TEST(SurfaceObjection, NoneToWhatOneMatcherGotWrong) {
  for (const std::size_t captures : {std::size_t{1}, std::size_t{8}}) {
    EXPECT_LT(mean_in_strip(objection_of({empty, empty, empty, with_strip}, captures, 3)), 1.0) << captures;
    EXPECT_LT(mean_in_strip(objection_of({empty, empty, with_strip, empty}, captures, 4)), 1.0) << captures;
  }
}

TEST(SurfaceObjection, NoneToWhatBothDepthImagesAgreeOn) {
  const SurfaceObjection objection = objection_of({empty, empty, empty, empty}, 8, 5);
  EXPECT_LT(*std::ranges::max_element(objection.variances.pixels()), 6.0F);
}

TEST(SurfaceObjection, IsNotJudgedWhereNoPairSees) {
  const SurfaceObjection objection = objection_of({empty, with_strip, empty, with_strip}, 1, 6);
  for (int v = 0; v < test::pair_camera.height; ++v) {
    EXPECT_EQ(objection.judged(1, v), 0);
    EXPECT_EQ(objection.variances(1, v), 0.0F);
  }
}

}  // namespace
}  // namespace rva
