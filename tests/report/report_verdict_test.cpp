#include "report/report_verdict.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace rva {
namespace {

constexpr const char* noon = "2026-01-01T12:00:00.000Z";

Decision decision(Verdict verdict, int round = 1) { return {verdict, "", "Ann", noon, round}; }

ReviewedFinding finding(int number, int same_as, std::optional<Decision> decided) {
  ReviewedFinding reviewed;
  reviewed.number = number;
  reviewed.same_as = same_as;
  reviewed.decision = std::move(decided);
  return reviewed;
}

MarkedFinding marked(std::optional<Decision> decided) {
  MarkedFinding mark;
  mark.number = 1;
  mark.decision = std::move(decided);
  return mark;
}

// One view in two comparisons, of which the second is valid and reviewed.
InspectionHistory reviewed(std::vector<ReviewedFinding> now, std::vector<ReviewedFinding> before = {}) {
  InspectionHistory history;
  Inspection& inspection = history.inspection;
  inspection.views = {{}};
  inspection.initial = TakenSide{noon, "Ann", "b", 1};
  inspection.final = TakenSide{noon, "Ann", "b", 2};
  inspection.comparison = RecordedComparison{2, noon, "comparison-2", 2};
  ComparedView view;
  view.judged = 0.764;
  view.findable = {{5.0, 0.4}, {10.0, 0.7}};
  inspection.compared = {view};
  inspection.findings = now;
  history.rounds = {
      {*inspection.comparison, inspection.final, inspection.compared, std::move(now)},
      {RecordedComparison{1, noon, "comparison-1", 1}, std::nullopt, {view}, std::move(before)}};
  return history;
}

InspectionHistory closed(InspectionHistory history) {
  history.inspection.closing = Closing{2, "Ida", "", noon};
  return history;
}

TEST(ReportVerdict, NothingIsStatedBeforeAnInspectionIsClosed) {
  InspectionHistory history;
  EXPECT_EQ(verdict_on(history).sentence, "Not finished: there is no baseline yet");
  EXPECT_EQ(extent_text(history.inspection), "");
  history = reviewed({finding(1, 1, decision(Verdict::false_alarm, 2)), finding(2, 2, std::nullopt)});
  EXPECT_EQ(verdict_on(history).sentence, "Not finished: 1 of 2 findings is not settled");
  history.inspection.findings[1].decision = decision(Verdict::second_look, 2);
  EXPECT_EQ(verdict_on(history).sentence, "Not finished: 1 of 2 findings is not settled");
  history.inspection.findings[1].decision = decision(Verdict::debris, 2);
  EXPECT_EQ(verdict_on(history).sentence, "Not finished: 1 of 2 findings is not settled");
  history.inspection.findings[1].decision = decision(Verdict::installed_work, 2);
  EXPECT_EQ(verdict_on(history).outcome, Outcome::unfinished);
  EXPECT_NE(verdict_on(history).sentence.find("nobody has closed"), std::string::npos);
  history.inspection.comparison.reset();
  EXPECT_EQ(verdict_on(history).sentence, "Not finished: the bay was not compared with its latest captures");
}

// A tool that is lost may be in the bay, whatever the pictures show.
TEST(ReportVerdict, ALostItemIsNoClearBay) {
  InspectionHistory history = reviewed({});
  CheckedOutItem wrench{
      .number = 1, .item = {"wrench", "T-12", 1}, .person = "Ann", .taken_at = noon, .statements = {}};
  history.inspection.items = {wrench};
  EXPECT_EQ(verdict_on(history).sentence, "Not finished: 1 item of the check-out list is not accounted for");
  ItemStatement statement{.returned = 0,
                          .used = 0,
                          .lost = 1,
                          .released = true,
                          .note = "why",
                          .person = "Ida",
                          .stated_at = noon};
  history.inspection.items[0].statements = {statement};
  EXPECT_EQ(verdict_on(closed(history)).outcome, Outcome::not_shown);
  EXPECT_EQ(verdict_on(closed(history)).sentence,
            "1 item of the check-out list is lost, and may be in the bay");
  statement = {
      .returned = 1, .used = 0, .lost = 0, .released = false, .note = "", .person = "Ida", .stated_at = noon};
  history.inspection.items[0].statements.push_back(statement);
  EXPECT_EQ(verdict_on(closed(history)).outcome, Outcome::clear);
}

TEST(ReportVerdict, DebrisThatWasRemovedBeforeTheLastCapturesIsCounted) {
  // Two findings of one object, in two views, count once.
  const auto history = closed(reviewed(
      {}, {finding(1, 1, decision(Verdict::debris_removed)), finding(2, 1, decision(Verdict::debris_removed)),
           finding(3, 3, decision(Verdict::false_alarm))}));
  const ReportVerdict verdict = verdict_on(history);
  EXPECT_EQ(verdict.outcome, Outcome::clear);
  EXPECT_EQ(verdict.sentence, "No debris remains in what was inspected");
  EXPECT_EQ(verdict.reason, "Round 1: 1 debris removed, 1 false alarm. Round 2: nothing found.");
}

TEST(ReportVerdict, DebrisThatWasRemovedAfterThemIsNotShownToBeGone) {
  const auto history = closed(reviewed({finding(1, 1, decision(Verdict::debris_removed, 2))}));
  EXPECT_EQ(verdict_on(history).outcome, Outcome::not_shown);
  EXPECT_EQ(verdict_on(history).sentence,
            "1 piece of debris was removed after the last captures, which do not show it gone");
  InspectionHistory by_hand = closed(reviewed({}));
  by_hand.inspection.marked = {marked(decision(Verdict::debris_removed, 2))};
  EXPECT_EQ(verdict_on(by_hand).outcome, Outcome::not_shown);
  by_hand.inspection.marked = {marked(decision(Verdict::debris_removed, 1))};
  EXPECT_EQ(verdict_on(by_hand).outcome, Outcome::clear) << "the second round was captured without it";
}

TEST(ReportVerdict, DebrisThatRemainsComesFirst) {
  auto history = closed(reviewed({finding(1, 1, decision(Verdict::debris_removed, 2)),
                                  finding(2, 2, decision(Verdict::debris_unreachable, 2))}));
  history.inspection.marked = {marked(decision(Verdict::debris_unreachable, 1))};
  EXPECT_EQ(verdict_on(history).outcome, Outcome::debris_left);
  EXPECT_EQ(verdict_on(history).sentence, "Debris remains: 2 pieces were not removed");
}

TEST(ReportVerdict, DebrisThatNobodyCouldReachIsNotGoneBecauseItIsNotFound) {
  const auto history = closed(reviewed({}, {finding(1, 1, decision(Verdict::debris_unreachable))}));
  EXPECT_EQ(verdict_on(history).outcome, Outcome::not_shown);
  EXPECT_EQ(
      verdict_on(history).sentence,
      "1 piece of debris could not be reached in an earlier round, and the last captures do not show it");
  const auto removed = closed(reviewed({}, {finding(1, 1, decision(Verdict::debris))}));
  EXPECT_EQ(verdict_on(removed).outcome, Outcome::clear)
      << "it was there, was removed, and is seen to be gone";
}

TEST(ReportVerdict, ClosedRecordsWithOpenFindingsAreNotClear) {
  EXPECT_EQ(verdict_on(closed(reviewed({finding(1, 1, std::nullopt)}))).sentence,
            "Closed, although 1 finding is not settled");
  EXPECT_EQ(verdict_on(closed(reviewed({finding(1, 1, decision(Verdict::debris, 2))}))).outcome,
            Outcome::debris_left);
}

TEST(ReportVerdict, LittleThatWasInspectedIsNotClear) {
  InspectionHistory history = closed(reviewed({}));
  history.inspection.compared[0].judged = 0.5;
  EXPECT_EQ(verdict_on(history).outcome, Outcome::clear);
  history.inspection.compared[0].judged = 0.49;
  EXPECT_EQ(verdict_on(history).outcome, Outcome::too_little);
  history.inspection.compared[0].judged = 0.9;
  history.inspection.views.emplace_back();
  EXPECT_EQ(verdict_on(history).outcome, Outcome::too_little) << "a view that was not compared";
}

TEST(ReportVerdict, StatesWhatItIsAbout) {
  InspectionHistory history = closed(reviewed({}));
  EXPECT_EQ(
      extent_text(history.inspection),
      "Inspected: 76 % of the view; objects of 5 mm would have been found in 40 % of it, of 10 mm in 70 %");
  history.inspection.views.emplace_back();
  ComparedView worse = history.inspection.compared[0];
  worse.view = 1;
  worse.judged = 0.5;
  worse.findable = {{10.0, 0.2}};
  history.inspection.compared.push_back(worse);
  EXPECT_EQ(extent_text(history.inspection),
            "Inspected: at least 50 % of each view; objects of 5 mm would have been found in at least 0 % of "
            "each view, of 10 mm in 20 %");
}

}  // namespace
}  // namespace rva
