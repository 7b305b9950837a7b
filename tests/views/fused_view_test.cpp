#include "views/fused_view.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/views/box_room.hpp"

namespace rva {
namespace {

using test::bay;
using test::pose;
using test::view_of;

std::vector<PlacedView> dithered(std::size_t count, double noise_px) {
  std::vector<PlacedView> views;
  const Transform first = pose(0, 0, 0);
  for (std::size_t k = 0; k < count; ++k) {
    const auto turn_deg = 0.325 * static_cast<double>(k);
    const Transform at = pose(0, 0, turn_deg, 15.0 + 0.5 * turn_deg);
    views.push_back({view_of(bay(), at, {noise_px, 0.0, 100 + k}), first.inverse() * at});
  }
  return views;
}

// Root mean square off what is really there, where there is no edge.
double error_px(const DepthView& view) {
  const DepthView truth = view_of(bay(), pose(0, 0, 0));
  double squares = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < truth.disparity_px.size(); ++i) {
    const double off = static_cast<double>(view.disparity_px[i] - truth.disparity_px[i]);
    if (!view.seen(i) || std::abs(off) > 0.5) continue;
    squares += off * off;
    count += 1.0;
  }
  return std::sqrt(squares / count);
}

TEST(FusedView, OfOneIsThatOne) {
  const std::vector<PlacedView> one = dithered(1, 0.1);
  EXPECT_EQ(fuse(one).disparity_px, one[0].view.disparity_px);
}

TEST(FusedView, AveragesWhatDiffersFromViewToView) {
  const double single_px = error_px(fuse(dithered(1, 0.15)));
  const double eight_px = error_px(fuse(dithered(8, 0.15)));
  EXPECT_NEAR(single_px, 0.15, 0.01);
  EXPECT_LT(eight_px, single_px / 2.5)
      << "an eighth of the variance; a little less, for views are interpolated";
}

TEST(FusedView, LeavesOutAWrongMatchAndWhatFewViewsSee) {
  std::vector<PlacedView> views = dithered(4, 0.0);
  views[2].view.disparity_px(200, 120) += 5.0F;
  DepthView fused = fuse(views);
  EXPECT_LT(error_px(fused), 0.02);
  for (std::size_t k = 1; k < views.size(); ++k) views[k].view.disparity_px = Image<float>(424, 240);
  fused = fuse(views);
  for (const float disparity_px : fused.disparity_px.pixels()) ASSERT_EQ(disparity_px, 0.0F);
}

TEST(FusedView, SaysHowViewsDiffer) {
  const DepthView fused = fuse(dithered(8, 0.2));
  const DepthView calm = fuse(dithered(8, 0.02));
  EXPECT_NEAR(fused.deviation_px(212, 200), 0.2, 0.12);
  EXPECT_LT(calm.deviation_px(212, 200), 0.05);
}

}  // namespace
}  // namespace rva
