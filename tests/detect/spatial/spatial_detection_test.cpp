#include "detect/spatial/spatial_detection.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "tests/views/shots.hpp"

namespace rva {
namespace {

using test::bay;
using test::littered;
using test::pose;
using test::shoot;
using test::side;

const Transform before = pose(0.12, 0.0, -5);
const Transform after = pose(-0.1, 0.02, 4);

TEST(SpatialDetection, FindsWhatWasLeftThoughTheRobotWasPutElsewhere) {
  const SpatialDetection found =
      detect_spatial(side(bay(), {{before, "b1", 1}}), side(littered(), {{after, "b2", 2}}), {}, {});
  const Findings& findings = found.detection.findings;
  ASSERT_EQ(findings.findings.size(), 1U);
  EXPECT_EQ(findings.findings[0].kind, ChangeKind::added);
  EXPECT_EQ(findings.method, "spatial");
  ASSERT_TRUE(findings.findings[0].position_m);
  const Eigen::Vector3d seen = after * *findings.findings[0].position_m;
  EXPECT_NEAR(seen.x(), 0.0, 0.03);
  EXPECT_NEAR(seen.z(), 0.66, 0.04);
  EXPECT_LT(test::error_of(findings.final_from_initial, after.inverse() * before).mm, 3.0);
  const Coverage& coverage = findings.coverage;
  EXPECT_NEAR(coverage.compared + coverage.unseen + coverage.invalid, 1.0, 1e-9);
  EXPECT_GT(coverage.unseen, 0.05);
  ASSERT_TRUE(found.detection.level_of_detection);
}

TEST(SpatialDetection, FindsNothingWhereNothingChanged) {
  EXPECT_TRUE(detect_spatial(side(bay(), {{before, "b1", 3}}), side(bay(), {{after, "b2", 4}}), {}, {})
                  .detection.findings.findings.empty());
}

TEST(SpatialDetection, TakesSeveralCapturesASide) {
  const auto aside = [](const Transform& from) {
    return Transform(from * Eigen::AngleAxisd(0.01, Eigen::Vector3d::UnitY()));
  };
  const SpatialDetection found =
      detect_spatial(side(bay(), {{before, "b1", 5}, {aside(before), "b1", 6}}),
                     side(littered(), {{after, "b2", 7}, {aside(after), "b2", 8}}), {}, {});
  EXPECT_EQ(found.detection.findings.findings.size(), 1U);
  EXPECT_EQ(found.detection.findings.initial_frames, 8U);
}

TEST(SpatialDetection, BelievesPosesOnlyAsFarAsTheViewsBearThemOut) {
  const SpatialDetection right =
      detect_spatial(side(bay(), {{before, "b1", 9}}), side(littered(), {{after, "b1", 10}}), {}, {});
  EXPECT_EQ(right.detection.findings.findings.size(), 1U);
  EXPECT_THAT(right.detection.warnings, testing::Not(testing::Contains(testing::HasSubstr("poses"))));
  // Half a metre and a quarter of a turn off.
  Captures wrong = side(littered(), {{after, "b2", 11}});
  CaptureInfo info = wrong[0]->info();
  info.pose = Pose{"b1", std::nullopt, std::nullopt, pose(0.5, 0.2, 45)};
  std::vector<DepthImage> frames;
  for (std::size_t k = 0; k < wrong[0]->depth_frames(); ++k) frames.push_back(wrong[0]->depth(k));
  Captures lying;
  lying.push_back(std::make_unique<test::MemoryCapture>(info, std::move(frames)));
  const SpatialDetection corrected = detect_spatial(side(bay(), {{before, "b1", 9}}), lying, {}, {});
  EXPECT_EQ(corrected.detection.findings.findings.size(), 1U);
  EXPECT_THAT(corrected.detection.warnings, testing::Contains(testing::HasSubstr("poses")));
}

TEST(SpatialDetection, RefusesRatherThanGuesses) {
  const test::Room wall{{test::box(-9, 9, -9, 9, 1.0, 1.1)}};
  try {
    (void)detect_spatial(side(wall, {{pose(0, 0, 0, 0), "b1", 12}}),
                         side(wall, {{pose(0.1, 0, 3, 0), "b2", 13}}), {}, {});
    FAIL() << "a wall does not constrain shifts along it";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr("nothing in view constrains"));
  }
  Captures bent = side(bay(), {{before, "b1", 14}});
  CaptureInfo info = bent[0]->info();
  info.depth.distortion = Distortion::brown_conrady;
  Captures lens;
  lens.push_back(std::make_unique<test::MemoryCapture>(info, std::vector<DepthImage>{bent[0]->depth(0)}));
  EXPECT_THROW((void)detect_spatial(lens, side(bay(), {{after, "b2", 15}}), {}, {}), Error);
}

TEST(Registration, IsWrittenAsJson) {
  Registration registration;
  registration.covariance(5, 5) = 1e-6;
  registration.agreeing = 0.8;
  const auto json = json_of(registration);
  EXPECT_EQ(json["format"], "rva-registration");
  EXPECT_EQ(json["initial_from_final"].size(), 16U);
  EXPECT_EQ(json["covariance"][35], 1e-6);
  EXPECT_EQ(json["agreeing"], 0.8);
}

}  // namespace
}  // namespace rva
