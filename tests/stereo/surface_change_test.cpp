#include "stereo/surface_change.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "tests/stereo/dithered_pairs.hpp"

namespace rva {
namespace {

constexpr double speckle = 0.12;
constexpr std::size_t captures = 8;

// A strip came 15 mm nearer: half a pixel of disparity.
const test::Plane before{};
const test::Plane after{.depth_m = 0.8, .slope = 0.0, .step_m = 0.015, .step_x_m = 0.05, .end_x_m = 0.1};

SurfaceChange change_of(const test::Plane& first, const test::Plane& second, std::uint64_t seed) {
  std::vector<StereoView> initial = test::dithered_pairs(first, captures, speckle, seed);
  std::vector<StereoView> final = test::dithered_pairs(second, captures, speckle, seed + 100);
  return surface_change(test::off_by(test::true_disparity(first), 0.3F), test::pair_stereo, initial, final);
}

float highest(const SurfaceChange& change, int first_u, int end_u) {
  float most = 0.0F;
  for (int v = 20; v < test::pair_camera.height - 20; ++v) {
    for (int u = first_u; u < end_u; ++u) most = std::max(most, std::abs(change.deviations(u, v)));
  }
  return most;
}

TEST(SurfaceChange, ShowsNothingWhereNothingMoved) {
  EXPECT_LT(highest(change_of(before, before, 1), 60, 220), 6.0F);
}

TEST(SurfaceChange, ShowsWhatCameNearerAndWhatWentAway) {
  const SurfaceChange nearer = change_of(before, after, 2);
  const SurfaceChange farther = change_of(after, before, 3);
  int found = 0;
  int count = 0;
  for (int v = 20; v < test::pair_camera.height - 20; ++v) {
    for (int u = 155; u < 165; ++u) {
      ++count;
      if (nearer.deviations(u, v) > 5.0F && farther.deviations(u, v) < -5.0F) ++found;
    }
  }
  EXPECT_GT(found, count * 9 / 10);
  EXPECT_LT(highest(nearer, 60, 125), 6.0F) << "beside it, nothing moved";
}

TEST(SurfaceChange, HowFarItMovedIsMeasured) {
  const SurfaceChange change = change_of(before, after, 4);
  const Image<float> from = test::true_disparity(before);
  const Image<float> to = test::true_disparity(after);
  double sum_px = 0.0;
  int count = 0;
  for (int v = 20; v < test::pair_camera.height - 20; ++v) {
    for (int u = 155; u < 165; ++u, ++count) sum_px += static_cast<double>(change.nearer_px(u, v));
  }
  EXPECT_NEAR(sum_px / count, static_cast<double>(to(160, 80) - from(160, 80)), 0.05);
}

// What a change of one pixel would show is known from the inspection itself: what half a pixel does show.
TEST(SurfaceChange, ForetellsHowMuchAChangeShows) {
  const SurfaceChange unchanged = change_of(before, before, 6);
  const SurfaceChange changed = change_of(before, after, 7);
  const Image<float> from = test::true_disparity(before);
  const Image<float> to = test::true_disparity(after);
  double foretold = 0.0;
  double shown = 0.0;
  for (int v = 20; v < test::pair_camera.height - 20; ++v) {
    for (int u = 155; u < 165; ++u) {
      foretold += static_cast<double>(unchanged.deviations_per_px(u, v) * (to(u, v) - from(u, v)));
      shown += static_cast<double>(changed.deviations(u, v));
    }
  }
  EXPECT_NEAR(foretold / shown, 1.0, 0.25);
}

TEST(SurfaceChange, IsNotJudgedWhereASideDoesNotSee) {
  const SurfaceChange change = change_of(before, before, 5);
  for (int v = 0; v < test::pair_camera.height; ++v) {
    EXPECT_EQ(change.judged(3, v), 0);
    EXPECT_EQ(change.deviations(3, v), 0.0F);
  }
}

}  // namespace
}  // namespace rva
