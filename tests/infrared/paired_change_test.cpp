#include "infrared/paired_change.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "tests/infrared/dotted_wall.hpp"

namespace rva {
namespace {

using test::dithers;
using test::Spot;
using test::views_at;
using test::WallLight;

// A robot that returns to each pose but for half a servo step on either side.
std::vector<Eigen::Vector3d> returned(std::vector<Eigen::Vector3d> turns, std::uint64_t seed) {
  constexpr double most_rad = 0.16 * std::numbers::pi / 180.0;
  Random random(seed);
  for (Eigen::Vector3d& turn : turns)
    turn += Eigen::Vector3d(random.uniform(-most_rad, most_rad), random.uniform(-most_rad, most_rad), 0.0);
  return turns;
}

PairedChange between(const std::vector<InfraredView>& before, const std::vector<InfraredView>& after) {
  const ReferenceSurface surface = test::wall_surface();
  return paired_change(surface, before, after, fuse(surface, before), test::well_inside());
}

std::ptrdiff_t judged(const PairedChange& change) {
  return std::ranges::count(change.judged.pixels(), mask_set);
}

float greatest(const PairedChange& change) {
  float most = 0.0F;
  for (const float deviations : change.deviations.pixels()) most = std::max(most, std::abs(deviations));
  return most;
}

// Seven millimetres: five pixels across, at this pixel.
const std::vector<Spot> dark_spot{{0.03, 0.02, 0.0075, 0.85}};
constexpr int spot_u = 180;
constexpr int spot_v = 133;

TEST(PairedChange, OfNothingIsWithinNoiseThoughTheRobotReturnsNearlyOnly) {
  for (std::uint64_t seed = 1; seed < 4; ++seed) {
    const PairedChange change = between(views_at(dithers(8, seed), 100 + seed),
                                        views_at(returned(dithers(8, seed), seed), 200 + seed));
    EXPECT_LT(greatest(change), 9.0F) << seed;
    EXPECT_GT(judged(change), 50000) << seed;
  }
}

TEST(PairedChange, OfASmallSpotStandsOutAndHasItsContrast) {
  const PairedChange change =
      between(views_at(dithers(8, 7), 31), views_at(returned(dithers(8, 7), 7), 32, {}, dark_spot));
  EXPECT_LT(change.deviations(spot_u, spot_v), -15.0F);
  EXPECT_NEAR(change.contrast(spot_u, spot_v), std::log(0.85F), 0.04F);
  EXPECT_LT(std::abs(change.deviations(spot_u + 40, spot_v)), 9.0F);
}

TEST(PairedChange, FourPairsInWhichDotsCoverNearlyEverythingShowTheSpot) {
  const WallLight dark{.background = 0.5};
  const PairedChange change =
      between(views_at(dithers(4, 9), 41, dark), views_at(returned(dithers(4, 9), 9), 42, dark, dark_spot));
  EXPECT_GT(judged(change), 50000);
  EXPECT_LT(change.deviations(spot_u, spot_v), -6.0F);
}

TEST(PairedChange, ExposureIsNone) {
  const PairedChange change =
      between(views_at(dithers(8, 3), 51), views_at(returned(dithers(8, 3), 3), 52, {.brightness = 1.3}));
  EXPECT_LT(greatest(change), 9.0F);
}

TEST(PairedChange, IsJudgedByPairsFromNearlyOnePoseOnly) {
  std::vector<Eigen::Vector3d> elsewhere = dithers(8, 5);
  for (Eigen::Vector3d& turn : elsewhere) turn += Eigen::Vector3d(0.0, 0.08, 0.0);
  EXPECT_EQ(judged(between(views_at(dithers(8, 5), 61), views_at(elsewhere, 62))), 0);
  EXPECT_EQ(judged(between(views_at(dithers(2, 5), 63), views_at(dithers(2, 5), 64))), 0) << "two pairs";
  EXPECT_EQ(judged(between(views_at(dithers(4, 5), 63), {})), 0);
}

PairedChange still(const WallLight& light_after, const std::vector<Spot>& spots, std::uint64_t seed) {
  const std::vector<Eigen::Vector3d> one_pose{Eigen::Vector3d::Zero()};
  return still_change(test::wall_surface(), views_at(one_pose, seed).front(),
                      views_at(one_pose, seed + 1, light_after, spots).front());
}

TEST(StillChange, OfNothingIsWithinNoiseWhateverTheExposure) {
  for (std::uint64_t seed = 1; seed < 4; ++seed) {
    const PairedChange change = still({.brightness = 1.2}, {}, 300 + 2 * seed);
    EXPECT_LT(greatest(change), 7.0F) << seed;
    EXPECT_GT(judged(change), 60000) << seed;
  }
}

TEST(StillChange, OneCaptureASideShowsASmallSpotAndItsContrast) {
  const PairedChange change = still({}, dark_spot, 311);
  EXPECT_LT(change.deviations(spot_u, spot_v), -10.0F);
  EXPECT_NEAR(change.contrast(spot_u, spot_v), std::log(0.85F), 0.05F);
  EXPECT_LT(std::abs(change.deviations(spot_u + 40, spot_v)), 7.0F);
}

TEST(PairedChange, TheSameImagesDifferNowhere) {
  const std::vector<InfraredView> views = views_at(dithers(4, 5), 81);
  const PairedChange change = between(views, views);
  EXPECT_TRUE(std::ranges::all_of(change.deviations.pixels(), [](float value) { return value == 0.0F; }));
  EXPECT_GT(judged(change), 50000);
}

TEST(PairedChange, SaturatedPixelsAreNotJudged) {
  const WallLight glaring{.background = 400.0};
  EXPECT_EQ(judged(between(views_at(dithers(4, 5), 71, glaring), views_at(dithers(4, 5), 72, glaring))), 0);
}

}  // namespace
}  // namespace rva
