#include "infrared/appearance_change.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/infrared/dotted_wall.hpp"

namespace rva {
namespace {

using test::dithers;
using test::Spot;
using test::views_at;
using test::WallLight;

AppearanceChange between(const std::vector<InfraredView>& before, const std::vector<InfraredView>& after) {
  const ReferenceSurface surface = test::wall_surface();
  return appearance_change(fuse(surface, before), fuse(surface, after), test::well_inside());
}

float greatest(const AppearanceChange& change) {
  float most = 0.0F;
  for (std::size_t i = 0; i < change.judged.size(); ++i) {
    if (change.judged[i] != 0) most = std::max(most, std::abs(change.deviations[i]));
  }
  return most;
}

TEST(AppearanceChange, OfNothingIsWithinNoise) {
  for (std::uint64_t seed = 1; seed < 6; ++seed) {
    const AppearanceChange change =
        between(views_at(dithers(8, seed), 100 + seed), views_at(dithers(8, seed), 200 + seed));
    EXPECT_LT(greatest(change), 5.0F) << seed;
    EXPECT_GT(std::ranges::count(change.judged.pixels(), mask_set), 40000) << seed;
  }
}

TEST(AppearanceChange, OfASmallSpotStandsOutAndHasItsContrast) {
  // Seven millimetres: five pixels across.
  const std::vector<Spot> spot{{0.03, 0.02, 0.0075, 0.85}};
  const AppearanceChange change = between(views_at(dithers(8, 7), 31), views_at(dithers(8, 7), 32, {}, spot));
  const int u = static_cast<int>(std::lround(159.5 + 400.0 * 0.03 / 0.6));
  const int v = static_cast<int>(std::lround(119.5 + 400.0 * 0.02 / 0.6));
  EXPECT_LT(change.deviations(u, v), -8.0F);
  EXPECT_LT(change.contrast(u, v), -0.04F) << "less what half a pixel off explains beside the spot's edges";
  EXPECT_GT(change.contrast(u, v), std::log(0.85F) - 0.03F);
  EXPECT_LT(std::abs(change.deviations(u + 40, v)), 5.0F);
}

TEST(AppearanceChange, ExposureAndAmbientLevelAreNone) {
  const AppearanceChange change =
      between(views_at(dithers(8, 3), 41), views_at(dithers(8, 3), 42, {.brightness = 1.4}));
  EXPECT_LT(greatest(change), 6.0F);
}

TEST(AppearanceChange, ATenthOfAPixelOfMisregistrationIsNone) {
  std::vector<InfraredView> after = views_at(dithers(8, 3), 52);
  for (InfraredView& view : after)
    view.view_from_reference = test::turned({0.1 / 400.0, 0.1 / 400.0, 0.0}) * view.view_from_reference;
  EXPECT_LT(greatest(between(views_at(dithers(8, 3), 51), after)), 6.0F);
}

TEST(AppearanceChange, IsNotJudgedWhereNoViewSeesASurfaceWithoutDots) {
  const std::vector<InfraredView> one = views_at({Eigen::Vector3d::Zero()}, 61);
  const AppearanceChange change = between(one, one);
  EXPECT_EQ(std::ranges::count(change.judged.pixels(), mask_set), 0)
      << "one view does not show how much noise there is";
}

}  // namespace
}  // namespace rva
