#include "sim/sensor/stereo_rig.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <numbers>
#include <vector>

namespace rva {
namespace {

using Field = double Misalignment::*;
constexpr Field drifting[] = {&Misalignment::offset_px, &Misalignment::scale_px, &Misalignment::row_offset_px,
                              &Misalignment::dots_px};

StereoSensorOptions with(double misalignment_px, double drift_px, std::uint64_t device = 1) {
  StereoSensorOptions options;
  options.misalignment_px = misalignment_px;
  options.drift_px = drift_px;
  options.device = device;
  return options;
}

double deviation_of(const StereoSensorOptions& options, Field field) {
  constexpr int captures = 400;
  double sum = 0.0;
  double squares = 0.0;
  for (std::uint64_t seed = 0; seed < captures; ++seed) {
    const double value = misalignment_of(options, seed).*field;
    sum += value / captures;
    squares += value * value / captures;
  }
  EXPECT_LT(std::abs(sum), 5.0 * std::sqrt(squares / captures));
  return std::sqrt(squares - sum * sum);
}

TEST(Misalignment, ThePerfectRigHasNone) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Misalignment misalignment = misalignment_of(with(0, 0), seed);
    for (const Field field : drifting) EXPECT_EQ(misalignment.*field, 0.0);
    EXPECT_EQ(misalignment.row_turn_px, 0.0);
  }
}

TEST(Misalignment, DriftsFromCaptureToCapture) {
  const StereoSensorOptions options = with(0, 0.05);
  EXPECT_NEAR(deviation_of(options, &Misalignment::offset_px), 0.05, 0.15 * 0.05);
  EXPECT_NEAR(deviation_of(options, &Misalignment::dots_px), 0.05, 0.15 * 0.05);
  for (const Field field : {&Misalignment::scale_px, &Misalignment::row_offset_px}) {
    EXPECT_GT(deviation_of(options, field), 0.005);
    EXPECT_LT(deviation_of(options, field), 0.05);
  }
}

TEST(Misalignment, DriftGrowsWithTheOption) {
  for (const Field field : drifting)
    EXPECT_NEAR(misalignment_of(with(0, 0.2), 3).*field, 4.0 * (misalignment_of(with(0, 0.05), 3).*field),
                1e-12);
}

TEST(Misalignment, OneCaptureIsOneDraw) {
  const StereoSensorOptions options = with(0.1, 0.05);
  for (const Field field : drifting) {
    EXPECT_EQ(misalignment_of(options, 7).*field, misalignment_of(options, 7).*field);
    EXPECT_NE(misalignment_of(options, 7).*field, misalignment_of(options, 8).*field);
  }
  EXPECT_NE(misalignment_of(options, 7).offset_px, misalignment_of(options, 7).dots_px);
}

TEST(Misalignment, TheFactorysPartStaysWithTheCamera) {
  for (std::uint64_t device = 1; device < 50; ++device) {
    const Misalignment first = misalignment_of(with(0.1, 0, device), 1);
    const Misalignment second = misalignment_of(with(0.1, 0, device), 2);
    const Misalignment other = misalignment_of(with(0.1, 0, device + 1), 1);
    EXPECT_EQ(first.row_offset_px, second.row_offset_px);
    EXPECT_EQ(first.row_turn_px, second.row_turn_px);
    EXPECT_NE(first.row_offset_px, other.row_offset_px);
    // At the image's edges, rows are not farther apart than the option by more than half of it.
    EXPECT_LE(std::abs(first.row_offset_px) + std::abs(first.row_turn_px), 0.15);
  }
}

TEST(StereoRig, FollowsTheOptions) {
  StereoSensorOptions options;
  options.focal_px = 500.0;
  options.baseline_mm = 95.0;
  const StereoRig rig = stereo_rig(options);
  EXPECT_EQ(rig.imager.fx, 500.0);
  EXPECT_EQ(rig.imager.fy, 500.0);
  EXPECT_DOUBLE_EQ(rig.baseline_m, 0.095);
  EXPECT_NO_THROW(rig.imager.check());
  EXPECT_NO_THROW(rig.color.check());
}

TEST(StereoRig, ImagersLookStraightAhead) {
  const StereoRig rig = stereo_rig({});
  for (const Intrinsics& imager : {rig.imager, rig.color}) {
    const Eigen::Vector3d first = imager.deproject({0, 0}, 1.0);
    const Eigen::Vector3d last = imager.deproject({imager.width - 1, imager.height - 1}, 1.0);
    EXPECT_TRUE((first + last).isApprox(Eigen::Vector3d(0, 0, 2), 1e-12));
  }
  const double across_deg = 2.0 * std::atan(rig.color.width / 2.0 / rig.color.fx) * 180.0 / std::numbers::pi;
  EXPECT_NEAR(across_deg, 69.0, 0.5);
}

TEST(StereoRig, TheColourImagerIsToTheLeft) {
  const Eigen::Vector3d color_in_depth = stereo_rig({}).color_from_depth.inverse().translation();
  EXPECT_TRUE(color_in_depth.isApprox(Eigen::Vector3d(-0.015, 0, 0), 1e-12));
}

}  // namespace
}  // namespace rva
