#include "inspect/view_comparison.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace rva {
namespace {

ReviewedFinding at(int view, double x_m, double score, ChangeKind kind = ChangeKind::added) {
  ReviewedFinding finding;
  finding.view = view;
  finding.finding.kind = kind;
  finding.finding.score = score;
  finding.in_foot_m = Eigen::Vector3d(x_m, 0.5, 0.0);
  return finding;
}

TEST(RankedFindings, AreMostSuspiciousFirstAndNumberedSo) {
  const std::vector<ReviewedFinding> ranked = rank({at(0, 0.0, 2.0), at(0, 0.5, 9.0), at(1, 1.0, 5.0)});
  ASSERT_EQ(ranked.size(), 3U);
  for (std::size_t i = 0; i < ranked.size(); ++i) EXPECT_EQ(ranked[i].number, static_cast<int>(i) + 1);
  EXPECT_EQ(ranked[0].finding.score, 9.0);
  EXPECT_EQ(ranked[2].finding.score, 2.0);
}

TEST(RankedFindings, OfAppearanceAloneComeAfterAllOthers) {
  ReviewedFinding seen = at(0, 0.3, 50.0, ChangeKind::appearance);
  seen.finding.evidence = {.depth = false, .appearance = true};
  const std::vector<ReviewedFinding> ranked = rank({seen, at(0, 0.0, 2.0), at(1, 0.6, 5.0)});
  EXPECT_EQ(ranked[0].finding.score, 5.0);
  EXPECT_EQ(ranked[2].finding.kind, ChangeKind::appearance);
}

TEST(RankedFindings, OfOneThingInSeveralViewsNameTheFirst) {
  const std::vector<ReviewedFinding> ranked = rank({at(0, 0.00, 9.0), at(1, 0.02, 5.0), at(2, -0.01, 7.0)});
  for (const ReviewedFinding& finding : ranked) EXPECT_EQ(finding.same_as, 1);
}

TEST(RankedFindings, OfOneViewOfAnotherKindOrFarApartAreOthers) {
  for (const ReviewedFinding& other :
       {at(0, 0.01, 5.0), at(1, 0.01, 5.0, ChangeKind::removed), at(1, 0.2, 5.0)}) {
    const std::vector<ReviewedFinding> ranked = rank({at(0, 0.0, 9.0), other});
    EXPECT_EQ(ranked[1].same_as, 2);
  }
}

TEST(RankedFindings, OfAThingThatWasMovedNameWhereItWasByItsNumber) {
  ReviewedFinding gone = at(1, 0.0, 9.0, ChangeKind::removed);
  ReviewedFinding come = at(1, 0.4, 5.0);
  ReviewedFinding elsewhere = at(0, 0.8, 7.0, ChangeKind::removed);
  gone.finding.id = elsewhere.finding.id = 1;
  come.finding.id = 2;
  come.finding.moved_from = 1;
  const std::vector<ReviewedFinding> ranked = rank({come, elsewhere, gone});
  EXPECT_EQ(ranked[2].moved_from, 1) << "of the same view";
  EXPECT_FALSE(ranked[0].moved_from || ranked[1].moved_from);
}

TEST(RankedFindings, WhatWasNotPlannedComesFirstAndWhatWasPlannedLast) {
  const auto with = [](ReviewedFinding finding, PlannedState state) {
    finding.planned = state;
    return finding;
  };
  ReviewedFinding absent = with(at(1, 0.0, 0.0), PlannedState::missing);
  absent.finding.score.reset();
  const std::vector<ReviewedFinding> ranked =
      rank({with(at(0, 0.0, 90.0), PlannedState::planned), with(at(0, 0.3, 80.0), PlannedState::surplus),
            absent, with(at(0, 0.6, 2.0), PlannedState::unplanned)});
  EXPECT_EQ(ranked[0].planned, PlannedState::unplanned);
  EXPECT_EQ(ranked[1].planned, PlannedState::missing);
  EXPECT_EQ(ranked[2].planned, PlannedState::surplus);
  EXPECT_EQ(ranked[3].planned, PlannedState::planned);
  EXPECT_EQ(ranked[3].same_as, 4) << "a part that is missing is not the one that another view shows there";
}

TEST(RankedFindings, WithoutAPositionStandAlone) {
  ReviewedFinding placeless = at(1, 0.0, 5.0);
  placeless.in_foot_m.reset();
  EXPECT_EQ(rank({at(0, 0.0, 9.0), placeless})[1].same_as, 2);
}

}  // namespace
}  // namespace rva
