#include "views/fused_change.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/views/box_room.hpp"

namespace rva {
namespace {

using test::bay;
using test::pose;
using test::view_of;

test::Room littered() {
  test::Room room = bay();
  room.boxes.push_back(test::box(-0.04, 0.04, 0.17, 0.25, 0.65, 0.72));
  return room;
}

// Two captures of one pose, each a little off.
PlacedChange change_at(const test::Room& before, const test::Room& after, std::size_t k, double drift_px) {
  const Transform first = pose(0, 0, 0);
  const auto turn_deg = 0.325 * static_cast<double>(k);
  const Transform at = pose(0, 0, turn_deg, 15.0 + 0.5 * turn_deg);
  constexpr double noise_px = 0.05;
  const DepthView initial = view_of(before, at, {noise_px, 0.0, 100 + k});
  const DepthView final = view_of(after, at, {noise_px, drift_px, 200 + k});
  DisparityChange change(initial.camera.width, initial.camera.height);
  change.frames = 10;
  change.before_px = initial.disparity_px;
  change.after_px = final.disparity_px;
  for (std::size_t i = 0; i < change.judged.size(); ++i) {
    if (!initial.seen(i) || !final.seen(i)) continue;
    change.judged[i] = mask_set;
    change.deviation_px[i] = static_cast<float>(noise_px);
  }
  return {std::move(change), first.inverse() * at};
}

DisparityChange fused(const test::Room& before, const test::Room& after, std::size_t count) {
  std::vector<PlacedChange> changes;
  for (std::size_t k = 0; k < count; ++k)
    changes.push_back(change_at(before, after, k, 0.3 * static_cast<double>(k % 2)));
  const Intrinsics camera = test::small_camera();
  return fuse(std::move(changes), camera, {.focal_baseline_m_px = camera.fx * test::baseline_m});
}

double spread_px(const DisparityChange& change) {
  double squares = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < change.judged.size(); ++i) {
    if (change.judged[i] == 0 || std::abs(change.change_px(i)) > 1.0F) continue;
    squares += static_cast<double>(change.change_px(i)) * static_cast<double>(change.change_px(i));
    count += 1.0;
  }
  return std::sqrt(squares / count);
}

TEST(FusedChange, OfOneIsThatOne) {
  const DisparityChange one = fused(bay(), bay(), 1);
  EXPECT_EQ(one.before_px, change_at(bay(), bay(), 0, 0.0).change.before_px);
}

TEST(FusedChange, AveragesNoiseAndRemovesEachViewsDrift) {
  const double single_px = spread_px(fused(bay(), bay(), 1));
  const double eight_px = spread_px(fused(bay(), bay(), 8));
  EXPECT_NEAR(single_px, 0.05 * std::sqrt(2.0), 0.005);
  EXPECT_LT(eight_px, single_px / 2.4) << "the root of eight, but for the uncertainty of the drift";
}

// Of the pixels that the litter covers, those whose change is its height, or less that height.
void expect_height_of_litter(const DisparityChange& change, float sign) {
  const DepthView with = view_of(littered(), pose(0, 0, 0));
  const DepthView without = view_of(bay(), pose(0, 0, 0));
  int compared = 0;
  int right = 0;
  for (std::size_t i = 0; i < change.judged.size(); ++i) {
    const float height_px = with.disparity_px[i] - without.disparity_px[i];
    if (height_px < 1.0F || change.judged[i] == 0) continue;
    ++compared;
    right += std::abs(change.change_px(i) - sign * height_px) < 0.3F ? 1 : 0;
  }
  EXPECT_GT(compared, 200);
  EXPECT_GT(right, 0.9 * compared) << "but at its outline";
}

TEST(FusedChange, HasTheHeightOfWhatCameAndOfWhatWent) {
  expect_height_of_litter(fused(bay(), littered(), 6), 1.0F);
  expect_height_of_litter(fused(littered(), bay(), 6), -1.0F);
}

TEST(FusedChange, JudgesOnlyWhatHalfOfTheViewsHave) {
  std::vector<PlacedChange> changes;
  for (std::size_t k = 0; k < 4; ++k) changes.push_back(change_at(bay(), bay(), k, 0.0));
  for (std::size_t k = 0; k < 3; ++k) {
    DisparityChange& change = changes[k].change;
    change.judged = Mask(change.judged.width(), change.judged.height());
  }
  const Intrinsics camera = test::small_camera();
  const DisparityChange change =
      fuse(std::move(changes), camera, {.focal_baseline_m_px = camera.fx * test::baseline_m});
  EXPECT_EQ(std::ranges::count(change.judged.pixels(), mask_set), 0);
  EXPECT_GT(std::ranges::count_if(change.before_px.pixels(), [](float px) { return px > 0.0F; }), 10000)
      << "it was seen before all the same";
}

}  // namespace
}  // namespace rva
