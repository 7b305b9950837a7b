#include "detect/static_detection.hpp"

#include <gtest/gtest.h>

#include <random>

#include "core/error.hpp"
#include "tests/depth/stacks.hpp"

namespace rva {
namespace {

using test::MemoryCapture;

// A wall at 1 m with noise of +-2 mm; `after` has a box of 12x8 px that stands 30 mm out.
std::vector<DepthImage> wall(int frames, bool with_box, unsigned seed) {
  std::mt19937 random(seed);
  std::vector<DepthImage> stack = test::random_stack({80, 60, frames}, 1000, 2, 0.02, random);
  if (!with_box) return stack;
  for (DepthImage& frame : stack) {
    for (int v = 20; v < 28; ++v) {
      for (int u = 30; u < 42; ++u) {
        if (frame(u, v) != no_depth) frame(u, v) = static_cast<std::uint16_t>(frame(u, v) - 30);
      }
    }
  }
  return stack;
}

TEST(Detection, FindsWhatWasLeft) {
  const MemoryCapture before = test::capture_of(wall(20, false, 1));
  const MemoryCapture after = test::capture_of(wall(20, true, 2));
  for (const DetectionMethod method :
       {DetectionMethod::constant, DetectionMethod::gaussian, DetectionMethod::calibrated}) {
    StaticDetectionOptions options;
    options.method = method;
    options.constant.threshold_m = 0.02;
    const Detection detection = detect_static(before, after, options, {}).detection;
    ASSERT_EQ(detection.findings.findings.size(), 1U);
    EXPECT_EQ(detection.findings.findings[0].box, (Box{30, 20, 12, 8}));
    EXPECT_NEAR(*detection.findings.findings[0].height_mm, 30.0, 2.0);
    EXPECT_TRUE(detection.warnings.empty());
    EXPECT_TRUE(detection.findings.final_from_initial.isApprox(Transform::Identity()));
  }
}

TEST(Detection, NothingChangedNothingFound) {
  const MemoryCapture before = test::capture_of(wall(20, false, 3));
  const MemoryCapture after = test::capture_of(wall(20, false, 4));
  EXPECT_TRUE(detect_static(before, after, {}, {}).detection.findings.findings.empty());
}

TEST(Detection, UsesTheFirstFramesOnly) {
  std::vector<DepthImage> frames = wall(10, true, 5);
  for (DepthImage& frame : wall(10, false, 6)) frames.push_back(std::move(frame));
  const MemoryCapture before = test::capture_of(wall(10, false, 7));
  StaticDetectionOptions options;
  options.use.frames = 10;
  const Detection detection = detect_static(before, test::capture_of(frames), options, {}).detection;
  EXPECT_EQ(detection.findings.findings.size(), 1U);
  EXPECT_EQ(detection.findings.final_frames, 10U);
}

TEST(Detection, SaysWhenFramesAreMissing) {
  StaticDetectionOptions options;
  options.use.frames = 10;
  const MemoryCapture capture = test::capture_of(wall(6, false, 8));
  const Detection detection = detect_static(capture, capture, options, {}).detection;
  EXPECT_EQ(detection.findings.initial_frames, 6U);
  EXPECT_EQ(detection.warnings.size(), 2U);
}

// Something that moves while either capture is recorded hides what else may have changed there.
TEST(Detection, WarnsWhereItIsBlind) {
  std::vector<DepthImage> moving = wall(8, false, 14);
  for (std::size_t k = 0; k < moving.size(); k += 2) {
    for (int u = 0; u < 20; ++u) {
      for (int v = 0; v < 60; ++v) moving[k](u, v) = 900;
    }
  }
  const MemoryCapture still = test::capture_of(wall(8, false, 15));
  EXPECT_EQ(detect_static(still, test::capture_of(moving), {}, {}).detection.warnings.size(), 1U);
  EXPECT_EQ(detect_static(test::capture_of(moving), still, {}, {}).detection.warnings.size(), 1U);
  EXPECT_TRUE(detect_static(still, still, {}, {}).detection.warnings.empty());
}

TEST(Detection, WarnsWhenLittleCouldBeCompared) {
  const MemoryCapture nothing = test::capture_of(std::vector<DepthImage>(4, DepthImage(80, 60)));
  const Detection detection = detect_static(nothing, nothing, {}, {}).detection;
  EXPECT_TRUE(detection.findings.findings.empty());
  EXPECT_EQ(detection.warnings.size(), 1U);
}

TEST(Detection, OneFrameHasNoDeviation) {
  const MemoryCapture one = test::capture_of(wall(1, false, 9));
  StaticDetectionOptions options;
  options.method = DetectionMethod::gaussian;
  EXPECT_THROW(static_cast<void>(detect_static(one, one, options, {}).detection), Error);
  options.method = DetectionMethod::constant;
  EXPECT_NO_THROW(static_cast<void>(detect_static(one, one, options, {}).detection));
}

TEST(Detection, OnlyCalibratedHasALevelOfDetection) {
  const MemoryCapture before = test::capture_of(wall(10, false, 16));
  const MemoryCapture after = test::capture_of(wall(10, true, 17));
  const Detection calibrated = detect_static(before, after, {}, {}).detection;
  ASSERT_TRUE(calibrated.level_of_detection);
  EXPECT_LT(*calibrated.findings.findings.at(0).p_value, 0.05);
  StaticDetectionOptions options;
  options.method = DetectionMethod::gaussian;
  const Detection gaussian = detect_static(before, after, options, {}).detection;
  EXPECT_FALSE(gaussian.level_of_detection);
  EXPECT_FALSE(gaussian.findings.findings.at(0).p_value);
}

TEST(Detection, RefusesAnotherCamera) {
  const MemoryCapture before = test::capture_of(wall(2, false, 10));
  const auto refused = [&](auto change) {
    CaptureInfo info = before.info();
    change(info);
    const MemoryCapture after(info, wall(2, false, 11));
    EXPECT_THROW(static_cast<void>(detect_static(before, after, {}, {}).detection), Error);
  };
  refused([](CaptureInfo& info) { info.depth.width = 81; });
  refused([](CaptureInfo& info) { info.depth.fx += 1.0; });
  refused([](CaptureInfo& info) { info.depth.cy += 0.1; });
  refused([](CaptureInfo& info) { info.depth.coefficients[0] = 0.1; });
  refused([](CaptureInfo& info) { info.depth_unit_m = 0.0001; });
}

TEST(Detection, NoticesPosesOfACameraThatMoved) {
  const auto differ = [](const Pose& a, const Pose& b) {
    CaptureInfo before = test::info_of(80, 60);
    CaptureInfo after = before;
    before.pose = a;
    after.pose = b;
    return poses_differ(before, after);
  };
  EXPECT_FALSE(differ({"b1", 10.0, -5.0, {}}, {"b1", 10.0, -5.0, {}}));
  EXPECT_TRUE(differ({"b1", 10.0, -5.0, {}}, {"b2", 10.0, -5.0, {}}));
  EXPECT_TRUE(differ({"b1", 10.0, -5.0, {}}, {"b1", 10.3, -5.0, {}}));
  EXPECT_FALSE(differ({{}, {}, {}, {}}, {"b1", 10.3, {}, {}}));
}

}  // namespace
}  // namespace rva
