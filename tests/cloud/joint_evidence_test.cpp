#include "cloud/joint_evidence.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <initializer_list>

namespace rva {
namespace {

constexpr int width = 40;
constexpr int height = 30;
constexpr double allowed = 0.025;
// What depth alone expects less often than a fiftieth of what is allowed.
const double sure = std::log10(50.0 / allowed) + 0.1;
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
      detection_of({finding(1, {at(5, 5), at(6, 5)}, sure), finding(2, {at(20, 5)}, usual)});
  drop_unsupported(judged_everywhere(), InfraredCompared::appearance, allowed, detection);
  ASSERT_EQ(detection.findings.findings.size(), 1U);
  EXPECT_EQ(detection.findings.findings.front().pixels.front(), at(5, 5));
  EXPECT_EQ(detection.changed[at(20, 5)], 0);
  EXPECT_EQ(detection.changed[at(6, 5)], mask_set);
}

TEST(JointEvidence, WhereSurfacesWereComparedDepthAloneMustBeSurer) {
  const double surest = std::log10(1e4 / allowed) + 0.1;
  Detection detection = detection_of({finding(1, {at(5, 5)}, surest), finding(2, {at(20, 5)}, sure)});
  drop_unsupported(judged_everywhere(), InfraredCompared::surfaces, allowed, detection);
  ASSERT_EQ(detection.findings.findings.size(), 1U);
  EXPECT_EQ(detection.findings.findings.front().pixels.front(), at(5, 5));
}

TEST(JointEvidence, WhatHasEvidenceStays) {
  Finding supported = finding(1, {at(5, 5)}, usual);
  supported.evidence.appearance = true;
  Detection detection = detection_of({supported});
  drop_unsupported(judged_everywhere(), InfraredCompared::appearance, allowed, detection);
  EXPECT_EQ(detection.findings.findings.size(), 1U);
}

TEST(JointEvidence, WhereInfraredImagesWereNotComparedDepthDecides) {
  Mask judged = judged_everywhere();
  judged[at(5, 5)] = 0;
  Detection detection = detection_of({finding(1, {at(5, 5), at(6, 5)}, usual)});
  drop_unsupported(judged, InfraredCompared::appearance, allowed, detection);
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
  Finding stays = finding(3, {at(5, 5)}, sure);
  stays.moved_from = 2;
  Finding loses = finding(4, {at(9, 5)}, sure);
  loses.moved_from = 1;
  Finding source = finding(2, {at(15, 5)}, sure);
  source.kind = ChangeKind::removed;
  Detection detection = detection_of({finding(1, {at(20, 5)}, usual), source, stays, loses});
  drop_unsupported(judged_everywhere(), InfraredCompared::appearance, allowed, detection);
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
