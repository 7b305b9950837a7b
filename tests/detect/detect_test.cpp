#include "detect/detect.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "tests/views/shots.hpp"

namespace rva {
namespace {

using test::bay;
using test::littered;
using test::side;
using testing::Contains;
using testing::HasSubstr;
using testing::IsEmpty;

// Poses state nothing where there is no base.
const Transform place = test::pose(0.12, 0.0, -5);
Transform turned(double right_deg) { return test::pose(0.12, 0.0, -5 + right_deg); }

SidesDetection compare(const Captures& initial, const Captures& final,
                       DetectionMethod method = DetectionMethod::automatic, const Mask& left_out = {}) {
  DetectOptions options;
  options.method = method;
  return detect(initial, final, options, {}, left_out);
}

std::size_t count(const SidesDetection& result) { return result.detection.findings.findings.size(); }

TEST(Detect, PixelsAreComparedWhereTheCameraStoodStill) {
  const SidesDetection found = compare(side(bay(), {{place, {}, 1}}), side(littered(), {{place, {}, 2}}));
  EXPECT_EQ(found.detection.findings.method, "calibrated");
  EXPECT_EQ(count(found), 1U);
  EXPECT_FALSE(found.registration);
  EXPECT_THAT(found.detection.warnings, testing::Not(Contains(HasSubstr("camera"))));
}

TEST(Detect, ACameraThatTurnedIsNoticedAndItsViewsAreRegistered) {
  for (const double turn_deg : {-0.1, 0.3, 1.0, -3.0}) {
    const SidesDetection same =
        compare(side(bay(), {{place, {}, 3}}), side(bay(), {{turned(turn_deg), {}, 4}}));
    EXPECT_EQ(same.detection.findings.method, "spatial") << turn_deg;
    EXPECT_EQ(count(same), 0U) << turn_deg;
    EXPECT_THAT(same.detection.warnings, Contains(HasSubstr("the camera turned by"))) << turn_deg;
    ASSERT_TRUE(same.registration);
    EXPECT_LT(test::error_of(same.registration->initial_from_final, place.inverse() * turned(turn_deg)).deg,
              0.1);
    const SidesDetection found =
        compare(side(bay(), {{place, {}, 5}}), side(littered(), {{turned(turn_deg), {}, 6}}));
    EXPECT_EQ(count(found), 1U) << turn_deg;
  }
}

TEST(Detect, AMethodByNameIsUsedAndTheMotionIsWarnedOf) {
  for (const DetectionMethod method :
       {DetectionMethod::constant, DetectionMethod::gaussian, DetectionMethod::calibrated}) {
    const SidesDetection found =
        compare(side(bay(), {{place, {}, 7}}), side(bay(), {{turned(1.0), {}, 8}}), method);
    EXPECT_EQ(found.detection.findings.method, name_of(method));
    EXPECT_THAT(found.detection.warnings, Contains(HasSubstr("the camera turned by")));
    const SidesDetection still =
        compare(side(bay(), {{place, {}, 9}}), side(bay(), {{place, {}, 10}}), method);
    EXPECT_THAT(still.detection.warnings, testing::Not(Contains(HasSubstr("the camera"))));
  }
}

// Servos that report the same step stand up to half a step apart.
TEST(Detect, StatedPosesAreCheckedAgainstTheImages) {
  const auto dithered = [](const test::Room& room, double off_deg, std::uint64_t seed) {
    Captures captures;
    for (const double dither_deg : {0.0, 0.65, -0.65}) {
      test::Shot shot{turned(dither_deg + off_deg), "b1", seed++};
      std::unique_ptr<Capture> taken = test::shoot(room, shot);
      CaptureInfo info = taken->info();
      info.pose->world_from_camera = turned(dither_deg);
      std::vector<DepthImage> frames;
      for (std::size_t k = 0; k < taken->depth_frames(); ++k) frames.push_back(taken->depth(k));
      captures.push_back(std::make_unique<test::MemoryCapture>(info, std::move(frames)));
    }
    return captures;
  };
  const SidesDetection exact = compare(dithered(bay(), 0.0, 20), dithered(littered(), 0.0, 30));
  EXPECT_THAT(exact.detection.warnings, testing::Not(Contains(HasSubstr("stated as equal"))));
  EXPECT_EQ(count(exact), 1U);
  for (const double off_deg : {0.1, -0.16, 0.325}) {
    const SidesDetection off = compare(dithered(bay(), 0.0, 40), dithered(littered(), off_deg, 50));
    EXPECT_THAT(off.detection.warnings, Contains(HasSubstr("stated as equal"))) << off_deg;
    EXPECT_EQ(count(off), 1U) << off_deg;
  }
}

TEST(Detect, TheBaselineOfAnotherBayIsRefused) {
  test::Room other{{test::box(-1.0, 1.0, 0.3, 0.35, -1.0, 2.0), test::box(-1.0, 1.0, -1.0, 0.35, 0.7, 0.8),
                    test::box(-0.2, 0.1, -0.3, 0.3, 0.45, 0.5)}};
  EXPECT_THROW(static_cast<void>(compare(side(bay(), {{place, {}, 11}}), side(other, {{place, {}, 12}}))),
               Error);
}

TEST(Detect, TheBaselineOfAnotherCameraIsRefused) {
  const auto of_camera = [](const char* serial, std::uint64_t seed) {
    const std::unique_ptr<Capture> taken = test::shoot(bay(), {place, {}, seed});
    CaptureInfo info = taken->info();
    info.camera->serial = serial;
    Captures captures;
    captures.push_back(std::make_unique<test::MemoryCapture>(
        info, std::vector<DepthImage>{taken->depth(0), taken->depth(1)}));
    return captures;
  };
  EXPECT_THROW(static_cast<void>(compare(of_camera("1", 13), of_camera("2", 14))), Error);
  EXPECT_NO_THROW(static_cast<void>(compare(of_camera("1", 13), of_camera("1", 14))));
}

TEST(Detect, WhatIsLeftOutIsNotFoundAndIsCounted) {
  const Intrinsics camera = test::small_camera();
  for (const double turn_deg : {0.0, 1.0}) {
    const Captures before = side(bay(), {{place, {}, 15}});
    const Captures after = side(littered(), {{turned(turn_deg), {}, 16}});
    const SidesDetection found = compare(before, after);
    ASSERT_EQ(count(found), 1U);
    // The debris in the initial view.
    const Finding& finding = found.detection.findings.findings[0];
    const Transform initial_from_final = found.detection.findings.final_from_initial.inverse();
    const Eigen::Vector2d at = camera.project(initial_from_final * *finding.position_m);
    Mask left_out(camera.width, camera.height);
    for (int v = -40; v <= 40; ++v) {
      for (int u = -40; u <= 40; ++u) {
        const Eigen::Vector2d pixel = at + Eigen::Vector2d(u, v);
        if (camera.contains(pixel))
          left_out(static_cast<int>(pixel.x()), static_cast<int>(pixel.y())) = mask_set;
      }
    }
    const SidesDetection without = compare(before, after, DetectionMethod::automatic, left_out);
    EXPECT_EQ(count(without), 0U) << turn_deg;
    const Coverage& coverage = without.detection.findings.coverage;
    ASSERT_TRUE(coverage.left_out);
    EXPECT_NEAR(*coverage.left_out, 81.0 * 81.0 / (camera.width * camera.height), 0.02);
    EXPECT_NEAR(coverage.compared + coverage.unseen + coverage.invalid + *coverage.left_out, 1.0, 1e-9);
  }
}

}  // namespace
}  // namespace rva
