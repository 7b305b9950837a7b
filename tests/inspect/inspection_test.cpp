#include "inspect/inspection.hpp"

#include <gtest/gtest.h>

namespace rva {
namespace {

ReviewedFinding decided(Verdict verdict) {
  ReviewedFinding finding;
  finding.decision = Decision{verdict, "", "Ann", "t"};
  return finding;
}

TEST(InspectionStage, FollowsFromWhatIsThere) {
  Inspection inspection;
  EXPECT_EQ(stage_of(inspection), Stage::baseline);
  inspection.initial = TakenSide{};
  EXPECT_EQ(stage_of(inspection), Stage::work);
  inspection.final = TakenSide{};
  EXPECT_EQ(stage_of(inspection), Stage::work) << "captured, but not compared";
  inspection.comparison = RecordedComparison{1, "t", "comparison-1"};
  EXPECT_EQ(stage_of(inspection), Stage::work) << "none of its views was compared";
  inspection.views = {{0, 0}, {10, 0}};
  inspection.compared = {{.view = 0, .method = "spatial", .coverage = {}, .judged = 0.7, .warnings = {}}};
  EXPECT_EQ(stage_of(inspection), Stage::work) << "one of its views was not compared";
  inspection.compared.push_back(
      {.view = 1, .method = "spatial", .coverage = {}, .judged = 0.4, .warnings = {}});
  EXPECT_EQ(least_judged(inspection), 0.4);
  EXPECT_EQ(stage_of(inspection), Stage::review) << "nobody has looked yet, though nothing was found";
  inspection.findings = {decided(Verdict::false_alarm), ReviewedFinding{}};
  EXPECT_EQ(stage_of(inspection), Stage::review);
  inspection.findings[1] = decided(Verdict::debris_removed);
  EXPECT_EQ(stage_of(inspection), Stage::review) << "nobody has closed it";
  inspection.closing = Closing{1, "Ann", "", "t"};
  EXPECT_EQ(stage_of(inspection), Stage::done);
}

TEST(Findings, AreUndecidedUntilNothingRemainsToBeDone) {
  Inspection inspection;
  inspection.findings = {ReviewedFinding{},
                         decided(Verdict::second_look),
                         decided(Verdict::debris),
                         decided(Verdict::debris_removed),
                         decided(Verdict::debris_unreachable),
                         decided(Verdict::installed_work),
                         decided(Verdict::false_alarm)};
  EXPECT_EQ(undecided(inspection), 3U);
  inspection.marked.emplace_back();
  EXPECT_EQ(undecided(inspection), 4U) << "what a person marked counts as well";
  EXPECT_EQ(summary_of(inspection).findings, 8U);
}

TEST(InspectionNames, LeadBackToWhatTheyName) {
  for (const Verdict verdict : {Verdict::debris, Verdict::debris_removed, Verdict::debris_unreachable,
                                Verdict::installed_work, Verdict::false_alarm, Verdict::second_look})
    EXPECT_EQ(value_of<Verdict>(name_of(verdict)), verdict);
  for (const Side side : {Side::initial, Side::final}) EXPECT_EQ(value_of<Side>(name_of(side)), side);
  EXPECT_FALSE(value_of<Verdict>("maybe"));
  EXPECT_FALSE(value_of<Side>(""));
}

}  // namespace
}  // namespace rva
