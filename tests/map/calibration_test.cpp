#include "map/calibration.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <numbers>

#include "core/error.hpp"
#include "tests/map/box_bay.hpp"

namespace rva {
namespace {

using test::BoxBayView;
using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr double rad_per_deg = std::numbers::pi / 180.0;

std::vector<MapView> seen(const std::vector<BoxBayView>& how, const PanTiltChain& chain,
                          const test::Room& room = test::bay()) {
  std::vector<MapView> views;
  for (const BoxBayView& view : how) views.push_back(test::box_bay_view(view, chain, room));
  return views;
}

// A robot that is not as it was drawn: 5 mm and 2 degrees off wherever a camera can tell.
PanTiltChain as_it_is() {
  PanTiltChain chain;
  chain.bracket.at_m.y() += 0.005;
  chain.bracket.axis = Eigen::AngleAxisd(-2.0 * rad_per_deg, Eigen::Vector3d::UnitY()) * chain.bracket.axis;
  chain.bracket_from_camera.translation() += 0.005 * Eigen::Vector3d(1.0, -1.0, 1.0).normalized();
  chain.bracket_from_camera.linear() =
      Eigen::AngleAxisd(2.0 * rad_per_deg, Eigen::Vector3d(1.0, 1.0, -1.0).normalized()) *
      chain.bracket_from_camera.linear();
  return chain;
}

TEST(Calibration, FindsAGeometryThatWasMeasuredBadly) {
  const PanTiltChain truth = as_it_is();
  const Calibration found = calibrate(seen(test::twelve_views(), truth), PanTiltChain{});
  EXPECT_EQ(found.doubt, "");
  const auto camera = test::error_of(found.chain.bracket_from_camera, truth.bracket_from_camera);
  EXPECT_LT(camera.mm, 1.0);
  EXPECT_LT(camera.deg, 0.1);
  EXPECT_LT((found.chain.bracket.at_m - truth.bracket.at_m).norm(), 0.001);
  EXPECT_GT(found.chain.bracket.axis.dot(truth.bracket.axis), std::cos(0.1 * rad_per_deg));
}

TEST(Calibration, SaysWhatItChangedAndHowSure) {
  const Calibration found = calibrate(seen(test::twelve_views(), as_it_is()), PanTiltChain{});
  ASSERT_EQ(found.numbers.size(), 8U);
  EXPECT_EQ(found.numbers[0].name, "tilt axis, forward of the pan axis");
  EXPECT_NEAR(found.numbers[0].change, 5.0, 1.0);
  EXPECT_NEAR(found.numbers[1].change, -2.0, 0.1);
  for (const CalibratedNumber& number : found.numbers) {
    EXPECT_TRUE(number.held) << number.name;
    EXPECT_GT(number.deviation, 0.0);
    EXPECT_LT(number.deviation, 4.0) << number.name;
  }
  for (const CalibratedView& view : found.views) {
    EXPECT_GT(view.after.share(), view.before.share());
    EXPECT_LT(std::abs(view.joint_error.pan_deg), 0.4);
  }
}

TEST(Calibration, LeavesAGoodGeometryAsItIs) {
  const Calibration found = calibrate(seen(test::twelve_views(), {}), PanTiltChain{});
  const auto error = test::error_of(found.chain.bracket_from_camera, PanTiltChain{}.bracket_from_camera);
  EXPECT_LT(error.mm, 1.0);
  EXPECT_LT(error.deg, 0.1);
}

TEST(Calibration, WhatNoCameraCanSeeStaysAsGiven) {
  PanTiltChain given;
  given.servo1 = {{0.02, -0.01, 0.3}, Eigen::Vector3d(0.01, 0.0, 1.0).normalized()};
  given.bracket.at_m.z() = 0.09;
  const Calibration found = calibrate(seen(test::twelve_views(), as_it_is()), given);
  EXPECT_EQ(found.chain.servo1.at_m, given.servo1.at_m);
  EXPECT_EQ(found.chain.servo1.axis, given.servo1.axis);
  EXPECT_EQ(found.chain.bracket.at_m.z(), given.bracket.at_m.z());
}

TEST(Calibration, RefusesABareWall) {
  const test::Room wall{{test::box(-9.0, 9.0, -9.0, 9.0, 0.9, 1.0)}};
  std::vector<BoxBayView> how = test::twelve_views();
  for (BoxBayView& view : how) view.joints.pan_deg *= 0.4;
  EXPECT_THAT(calibrate(seen(how, {}, wall), PanTiltChain{}).doubt, HasSubstr("do not determine"));
}

TEST(Calibration, NeedsJointsThatTurn) {
  std::vector<BoxBayView> how = test::twelve_views();
  const std::vector<BoxBayView> row(how.begin(), how.begin() + 4);
  EXPECT_THAT([&] { (void)calibrate(seen(row, {}), {}); },
              ThrowsMessage<Error>(HasSubstr("tilt turns by less")));
  for (BoxBayView& view : how) view.joints.pan_deg = 3.0;
  EXPECT_THAT([&] { (void)calibrate(seen(how, {}), {}); },
              ThrowsMessage<Error>(HasSubstr("pan turns by less")));
  how.resize(2);
  EXPECT_THAT([&] { (void)calibrate(seen(how, {}), {}); }, ThrowsMessage<Error>(HasSubstr("too few")));
}

}  // namespace
}  // namespace rva
