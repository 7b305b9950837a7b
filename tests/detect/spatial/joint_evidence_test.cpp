#include "detect/spatial/joint_evidence.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

#include "geometry/stereo_scale.hpp"

namespace rva {
namespace {

constexpr int width = 40;
constexpr int height = 30;
constexpr double allowed = 0.025;
constexpr StereoScale stereo{.focal_baseline_m_px = 32.0};
// What depth alone expects less often than a fiftieth of what is allowed.
const double reliable = std::log10(50.0 / allowed) + 0.1;
const double usual = -std::log10(allowed) + 0.1;

std::uint32_t at(int u, int v) { return static_cast<std::uint32_t>(v * width + u); }

Finding finding(int id, std::initializer_list<std::uint32_t> pixels, double score) {
  Finding one;
  one.id = id;
  one.pixels = pixels;
  one.score = score;
  return one;
}

Mask judged_everywhere() { return {width, height, mask_set}; }

Detection detection_of(std::vector<Finding> findings) {
  Detection detection;
  detection.changed = Mask(width, height);
  for (const Finding& one : findings) {
    for (const std::uint32_t i : one.pixels) detection.changed[i] = mask_set;
  }
  detection.findings.findings = std::move(findings);
  return detection;
}

TEST(JointEvidence, WhatInfraredImagesContradictIsDroppedUnlessDepthIsSure) {
  Detection detection =
      detection_of({finding(1, {at(5, 5), at(6, 5)}, reliable), finding(2, {at(20, 5)}, usual)});
  drop_unsupported({judged_everywhere(), InfraredCompared::appearance, stereo}, allowed, detection);
  ASSERT_EQ(detection.findings.findings.size(), 1U);
  EXPECT_EQ(detection.findings.findings.front().pixels.front(), at(5, 5));
  EXPECT_EQ(detection.changed[at(20, 5)], 0);
  EXPECT_EQ(detection.changed[at(6, 5)], mask_set);
}

TEST(JointEvidence, WhereSurfacesWereComparedDepthAloneMustBeSurer) {
  const double surest = std::log10(1e4 / allowed) + 0.1;
  Detection detection = detection_of({finding(1, {at(5, 5)}, surest), finding(2, {at(20, 5)}, reliable)});
  drop_unsupported({judged_everywhere(), InfraredCompared::surfaces, stereo}, allowed, detection);
  ASSERT_EQ(detection.findings.findings.size(), 1U);
  EXPECT_EQ(detection.findings.findings.front().pixels.front(), at(5, 5));
}

// A pixel of disparity, 32 m px at half a metre, is 8 mm.
Finding raised(int id, std::initializer_list<std::uint32_t> pixels, double height_mm) {
  constexpr double rarer_than_any_threshold = 30.0;
  Finding one = finding(id, pixels, rarer_than_any_threshold);
  one.height_mm = height_mm;
  one.position_m = Eigen::Vector3d(0.0, 0.0, 0.5);
  return one;
}

TEST(JointEvidence, ImagesOfAStillCameraThatDoNotDifferContradictWhatMovedByAPixel) {
  Finding seen = raised(5, {at(30, 5)}, 20.0);
  seen.evidence.appearance = true;
  Finding lost = raised(6, {at(5, 20)}, 0.0);
  lost.height_mm.reset();
  Detection detection = detection_of({raised(1, {at(5, 5)}, 9.0), raised(2, {at(10, 5)}, -9.0),
                                      raised(3, {at(20, 5)}, 7.0), raised(4, {at(25, 5)}, -7.0), seen, lost});
  drop_unsupported({judged_everywhere(), InfraredCompared::still, stereo}, allowed, detection);
  ASSERT_EQ(detection.findings.findings.size(), 3U);
  EXPECT_EQ(detection.findings.findings[0].pixels.front(), at(20, 5));
  EXPECT_EQ(detection.findings.findings[1].pixels.front(), at(25, 5));
  EXPECT_EQ(detection.findings.findings[2].pixels.front(), at(30, 5));
}

TEST(JointEvidence, ACameraThatMovedMayHaveDotsElsewhere) {
  Detection detection = detection_of({raised(1, {at(5, 5)}, 20.0)});
  drop_unsupported({judged_everywhere(), InfraredCompared::surfaces, stereo}, allowed, detection);
  EXPECT_EQ(detection.findings.findings.size(), 1U);
}

// Four pixels are two wide: 2 mm at half a metre.
TEST(JointEvidence, ASpikeOfSurfacesAloneIsAWrongMatch) {
  constexpr double focal_px = 500.0;
  const std::initializer_list<std::uint32_t> square{at(5, 5), at(6, 5), at(5, 6), at(6, 6)};
  EXPECT_TRUE(is_spike_of_surfaces(raised(1, square, 6.1), focal_px));
  EXPECT_TRUE(is_spike_of_surfaces(raised(1, square, -6.1), focal_px));
  EXPECT_FALSE(is_spike_of_surfaces(raised(1, square, 5.9), focal_px));
  Finding seen = raised(1, square, 60.0);
  seen.evidence.appearance = true;
  EXPECT_FALSE(is_spike_of_surfaces(seen, focal_px));
  Finding nowhere = raised(1, square, 60.0);
  nowhere.position_m.reset();
  EXPECT_FALSE(is_spike_of_surfaces(nowhere, focal_px));
}

TEST(JointEvidence, WhatHasEvidenceStays) {
  Finding supported = finding(1, {at(5, 5)}, usual);
  supported.evidence.appearance = true;
  Detection detection = detection_of({supported});
  drop_unsupported({judged_everywhere(), InfraredCompared::appearance, stereo}, allowed, detection);
  EXPECT_EQ(detection.findings.findings.size(), 1U);
}

TEST(JointEvidence, WhereInfraredImagesWereNotComparedDepthDecides) {
  Mask judged = judged_everywhere();
  judged[at(5, 5)] = 0;
  Detection detection = detection_of({finding(1, {at(5, 5), at(6, 5)}, usual)});
  drop_unsupported({judged, InfraredCompared::appearance, stereo}, allowed, detection);
  EXPECT_EQ(detection.findings.findings.size(), 1U) << "half of it is not most of it";
}

TEST(JointEvidence, TheMostSuspiciousComeFirstAndAppearanceLast) {
  Finding seen = finding(1, {at(5, 5)}, 9.0);
  seen.evidence = {.depth = false, .appearance = true};
  Finding moved = finding(3, {at(9, 5)}, 2.0);
  moved.moved_from = 4;
  std::vector<Finding> findings{seen, finding(2, {at(7, 5)}, 1.0), moved, finding(4, {at(20, 5)}, 3.0)};
  order(findings);
  const std::vector<double> scores{3.0, 2.0, 1.0, 9.0};
  for (std::size_t k = 0; k < findings.size(); ++k) {
    EXPECT_EQ(findings[k].id, static_cast<int>(k) + 1);
    EXPECT_EQ(findings[k].score, scores[k]);
  }
  EXPECT_EQ(findings[1].moved_from, 1);
}

TEST(JointEvidence, NumbersStayWithoutGapsAndReferToWhatIsLeft) {
  Finding stays = finding(3, {at(5, 5)}, reliable);
  stays.moved_from = 2;
  Finding loses = finding(4, {at(9, 5)}, reliable);
  loses.moved_from = 1;
  Finding source = finding(2, {at(15, 5)}, reliable);
  source.kind = ChangeKind::removed;
  Detection detection = detection_of({finding(1, {at(20, 5)}, usual), source, stays, loses});
  drop_unsupported({judged_everywhere(), InfraredCompared::appearance, stereo}, allowed, detection);
  const std::vector<Finding>& left = detection.findings.findings;
  ASSERT_EQ(left.size(), 3U);
  for (std::size_t k = 0; k < left.size(); ++k) EXPECT_EQ(left[k].id, static_cast<int>(k) + 1);
  EXPECT_EQ(left[1].moved_from, 1);
  EXPECT_EQ(left[2].moved_from, std::nullopt);
}

TEST(JointEvidence, ABlobBesideAFindingIsItsEvidenceAndOneFartherOffIsNot) {
  std::vector<Finding> findings{finding(1, {at(5, 5)}, usual), finding(2, {at(5, 20)}, usual)};
  Mask significant(width, height);
  for (const int u : {8, 9, 15, 16}) significant(u, 5) = mask_set;
  give_evidence(significant, findings);
  EXPECT_TRUE(findings[0].evidence.appearance);
  EXPECT_FALSE(findings[1].evidence.appearance);
  EXPECT_EQ(significant(8, 5), 0);
  EXPECT_EQ(significant(9, 5), 0) << "the whole blob";
  EXPECT_EQ(significant(15, 5), mask_set);
}

}  // namespace
}  // namespace rva
