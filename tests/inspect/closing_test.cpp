#include "inspect/closing.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "core/error.hpp"

namespace rva {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// An inspection of one view after round 2, with one finding.
Inspection reviewed(Verdict verdict) {
  Inspection inspection;
  inspection.id = 7;
  inspection.views = {{0, 0}};
  inspection.initial = TakenSide{"t", "Ann", "base", 1};
  inspection.final = TakenSide{"t", "Ann", "base", 2};
  inspection.comparison = RecordedComparison{3, "t", "comparison-3", 2};
  inspection.compared = {{.view = 0, .method = "spatial", .coverage = {}, .judged = 0.7, .warnings = {}}};
  inspection.findings.emplace_back();
  inspection.findings[0].decision = Decision{verdict, "", "Ann", "t", 2};
  return inspection;
}

std::string refusal(const Inspection& inspection, const Closing& closing = {3, "Ann", "", "t"}) {
  try {
    require_closable(inspection, closing);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(ClosingAnInspection, NeedsADecisionOnEveryFinding) {
  EXPECT_EQ(refusal(reviewed(Verdict::false_alarm)), "");
  EXPECT_EQ(refusal(reviewed(Verdict::installed_work)), "");
  EXPECT_THAT(refusal(reviewed(Verdict::second_look)), HasSubstr("undecided"));
  EXPECT_THAT(refusal(reviewed(Verdict::debris)), HasSubstr("still there"));
  Inspection marked = reviewed(Verdict::false_alarm);
  marked.marked.emplace_back();
  EXPECT_THAT(refusal(marked), HasSubstr("undecided"));
}

TEST(ClosingAnInspection, WithoutAPictureOfABayFreeOfDebrisNeedsANote) {
  for (const Verdict verdict : {Verdict::debris_removed, Verdict::debris_unreachable}) {
    EXPECT_THAT(refusal(reviewed(verdict)), HasSubstr("note"));
    EXPECT_EQ(refusal(reviewed(verdict), {3, "Ann", "seen with a mirror", "t"}), "");
  }
}

// A mark stays through later rounds: one that was removed before the last one is shown to be gone.
TEST(ClosingAnInspection, DebrisThatWasRemovedBeforeTheLastRoundNeedsNoNote) {
  Inspection inspection = reviewed(Verdict::false_alarm);
  inspection.marked.emplace_back();
  inspection.marked[0].decision = Decision{Verdict::debris_removed, "", "Ann", "t", 1};
  EXPECT_THAT(reasons_for_note(inspection), IsEmpty());
  EXPECT_EQ(refusal(inspection), "");
  inspection.marked[0].decision->round = 2;
  EXPECT_THAT(reasons_for_note(inspection), ElementsAre(ClosingReason::debris));
  inspection.marked[0].decision = Decision{Verdict::debris_unreachable, "", "Ann", "t", 1};
  EXPECT_THAT(reasons_for_note(inspection), ElementsAre(ClosingReason::debris))
      << "it is there in every round";
}

TEST(ClosingAnInspection, WithLessThanHalfOfAViewInspectedNeedsANote) {
  Inspection inspection = reviewed(Verdict::false_alarm);
  inspection.views.push_back({5, 0});
  inspection.compared.push_back(inspection.compared[0]);
  inspection.compared[1].view = 1;
  inspection.compared[1].judged = least_inspected;
  EXPECT_EQ(refusal(inspection), "");
  inspection.compared[1].judged = 0.49;
  EXPECT_THAT(reasons_for_note(inspection), ElementsAre(ClosingReason::coverage));
  EXPECT_THAT(refusal(inspection), HasSubstr("less than half of a view"));
  EXPECT_EQ(refusal(inspection, {3, "Ann", "the rest was looked at by mirror", "t"}), "");
  inspection.findings[0].decision->verdict = Verdict::debris_unreachable;
  EXPECT_THAT(reasons_for_note(inspection), ElementsAre(ClosingReason::debris, ClosingReason::coverage));
}

TEST(ClosingAnInspection, NeedsEachItemOfTheCheckOutListAccountedFor) {
  Inspection inspection = reviewed(Verdict::false_alarm);
  CheckedOutItem wrench{
      .number = 1, .item = {"wrench", "T-12", 1}, .person = "Ann", .taken_at = "t", .statements = {}};
  inspection.items = {wrench};
  EXPECT_THAT(refusal(inspection), HasSubstr("1 item(s) of the check-out list are not accounted for"));
  ItemStatement statement{
      .returned = 0, .used = 0, .lost = 1, .released = false, .note = {}, .person = "Ann", .stated_at = "t"};
  inspection.items[0].statements = {statement};
  EXPECT_THAT(refusal(inspection, {3, "Ann", "a note does not help", "t"}), HasSubstr("are lost"));
  statement.released = true;
  inspection.items[0].statements.push_back(statement);
  EXPECT_THAT(reasons_for_note(inspection), ElementsAre(ClosingReason::lost_item));
  EXPECT_THAT(refusal(inspection), HasSubstr("note"));
  EXPECT_EQ(refusal(inspection, {3, "Ann", "searched by borescope", "t"}), "");
  statement = {
      .returned = 1, .used = 0, .lost = 0, .released = false, .note = {}, .person = "Ann", .stated_at = "t"};
  inspection.items[0].statements.push_back(statement);
  EXPECT_THAT(reasons_for_note(inspection), IsEmpty()) << "it was found";
  EXPECT_EQ(refusal(inspection), "");
}

TEST(ClosingAnInspection, IsOfWhatThePersonReviewed) {
  EXPECT_THAT(refusal(reviewed(Verdict::false_alarm), {2, "Ann", "", "t"}), HasSubstr("compared again"));
  Inspection begun = reviewed(Verdict::false_alarm);
  begun.begun[Side::final] = {3, "Bob", "base"};
  EXPECT_THAT(refusal(begun), HasSubstr("not completed"));
  Inspection outdated = reviewed(Verdict::false_alarm);
  outdated.comparison.reset();
  EXPECT_THAT(refusal(outdated), HasSubstr("not been compared"));
  Inspection partial = reviewed(Verdict::false_alarm);
  partial.views.push_back({5, 0});
  EXPECT_THAT(refusal(partial), HasSubstr("not been compared"));
}

TEST(ClosingAnInspection, HappensOnce) {
  Inspection inspection = reviewed(Verdict::false_alarm);
  EXPECT_NO_THROW(require_open(inspection));
  inspection.closing = Closing{3, "Bob", "", "t"};
  EXPECT_THAT(refusal(inspection), HasSubstr("closed by Bob"));
  EXPECT_THROW(require_open(inspection), Error);
}

}  // namespace
}  // namespace rva
