#include "store/sqlite_records.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "tests/store/kept.hpp"

namespace rva {
namespace {

using test::comparison;
using test::finding;
using test::Kept;
using testing::ElementsAre;
using testing::SizeIs;

TEST_F(Kept, AnInspectionComesBackAsItWasAfterARestart) {
  const std::int64_t id = add();
  records_->set_views(id, {{-10.5, 3}, {12, -20.15}});
  records_->set_side(id, Side::initial, {"2026-01-01T01:00:00Z", "Ann", "base"});
  records_->set_side(id, Side::final, {"2026-01-01T02:00:00Z", "Bob", "other"});
  records_->set_comparison(
      id, {1, "2026-01-01T03:00:00Z", "comparison-1"},
      {{0, "spatial", {0.9, 0.06, 0.04, {}}, 0.8, {"a \"word\""}, {{5.0, 0.25}, {10.0, 0.5}}}},
      {finding(1), finding(2)});
  open();
  const std::optional<Inspection> back = records_->find(id);
  ASSERT_TRUE(back);
  EXPECT_EQ(back->order.person, "Ann O'Neil \"x\"; drop table view");
  EXPECT_EQ(back->dither, 4);
  EXPECT_THAT(back->views, ElementsAre(PanTilt{-10.5, 3}, PanTilt{12, -20.15}));
  EXPECT_EQ(back->initial->person, "Ann");
  EXPECT_EQ(back->final->base, "other");
  ASSERT_THAT(back->compared, SizeIs(1));
  EXPECT_EQ(back->compared[0].coverage.unseen, 0.06);
  EXPECT_THAT(back->compared[0].warnings, ElementsAre("a \"word\""));
  ASSERT_THAT(back->compared[0].findable, SizeIs(2));
  EXPECT_EQ(back->compared[0].findable[1].size_mm, 10.0);
  EXPECT_EQ(back->compared[0].findable[1].share, 0.5);
  ASSERT_THAT(back->findings, SizeIs(2));
  const Finding& first = back->findings[0].finding;
  EXPECT_EQ(first.position_m, finding(1).finding.position_m) << "to the last bit";
  EXPECT_EQ(first.size_mm, finding(1).finding.size_mm);
  EXPECT_EQ(first.p_value, 1e-9);
  EXPECT_EQ(first.above_surroundings_mm, 5.9);
  EXPECT_EQ(first.top_above_surroundings_mm, 7.5);
  EXPECT_TRUE(first.top_is_least);
  EXPECT_EQ(back->findings[0].clear_px, 120);
  EXPECT_EQ(back->findings[0].likely_class, "fastener");
  EXPECT_EQ(back->findings[0].class_probability, 0.75);
  EXPECT_TRUE(first.background_jump);
  EXPECT_EQ(first.box, (Box{1, 2, 3, 4}));
  EXPECT_EQ(back->findings[1].finding.kind, ChangeKind::removed);
}

TEST_F(Kept, ACheckOutListComesBackWithEveryStatement) {
  const std::int64_t id = add();
  records_->add_items(id, {{"wrench", "T-12", 1}, {"collar", "", 24}}, "Ann", "t1");
  records_->add_items(id, {{"rag", "", 2}}, "Bob", "t2");
  records_->state_item(id, 2,
                       {.returned = 20,
                        .used = 3,
                        .lost = 1,
                        .released = false,
                        .note = "",
                        .person = "Bob",
                        .stated_at = "t3"});
  records_->state_item(id, 2,
                       {.returned = 20,
                        .used = 3,
                        .lost = 1,
                        .released = true,
                        .note = "why",
                        .person = "Ida",
                        .stated_at = "t4"});
  open();
  const std::vector<CheckedOutItem> items = records_->find(id)->items;
  ASSERT_THAT(items, SizeIs(3));
  EXPECT_EQ(items[0].item, (ListedItem{"wrench", "T-12", 1}));
  EXPECT_EQ(items[2].number, 3);
  EXPECT_EQ(items[2].person, "Bob");
  ASSERT_THAT(items[1].statements, SizeIs(2));
  EXPECT_EQ(items[1].statements[0].person, "Bob");
  EXPECT_TRUE(items[1].statements[1].released);
  EXPECT_EQ(items[1].statements[1].note, "why");
  EXPECT_EQ(items[1].statements[1].stated_at, "t4");
}

TEST_F(Kept, AnItemThatMayNotBeStatedSoChangesNothing) {
  const std::int64_t id = add();
  records_->add_items(id, {{"wrench", "T-12", 1}}, "Ann", "t1");
  const ItemStatement too_many{
      .returned = 2, .used = 0, .lost = 0, .released = false, .note = "", .person = "Ann", .stated_at = "t"};
  EXPECT_THROW(records_->state_item(id, 1, too_many), Error);
  EXPECT_THROW(records_->state_item(id, 2, {}), Error);
  EXPECT_THROW(records_->state_item(id + 1, 1, {}), Error);
  EXPECT_THROW(
      records_->add_items(id, std::vector<ListedItem>(most_listed_items, {"rivet", "", 1}), "Ann", "t"),
      Error);
  const std::vector<CheckedOutItem> items = records_->find(id)->items;
  ASSERT_THAT(items, SizeIs(1));
  EXPECT_THAT(items[0].statements, SizeIs(0));
  EXPECT_THROW(records_->remove(id), Error) << "the list is kept";
}

TEST_F(Kept, WhatAMethodCouldNotGiveStaysEmpty) {
  const std::int64_t id = add();
  ReviewedFinding bare;
  bare.number = bare.same_as = 1;
  records_->set_comparison(id, comparison(1), {}, {bare});
  const ReviewedFinding back = records_->find(id)->findings.at(0);
  EXPECT_FALSE(back.finding.position_m || back.in_foot_m || back.finding.size_mm || back.finding.height_mm ||
               back.finding.score || back.finding.p_value || back.decision);
}

TEST_F(Kept, TheLastDecisionHoldsAndANewComparisonBeginsAnew) {
  const std::int64_t id = add();
  records_->set_comparison(id, comparison(1), {}, {finding(1)});
  records_->decide(id, 1, 1, {Verdict::second_look, "?", "Ann", "t1"});
  records_->decide(id, 1, 1, {Verdict::debris_removed, "a collar", "Bob", "t2"});
  EXPECT_EQ(records_->find(id)->findings[0].decision->verdict, Verdict::debris_removed);
  EXPECT_EQ(records_->find(id)->findings[0].decision->person, "Bob");
  records_->set_comparison(id, comparison(2), {}, {finding(1)});
  EXPECT_FALSE(records_->find(id)->findings[0].decision);
  SQLite::Database file((folder_ / "rva.db").string());
  EXPECT_EQ(file.execAndGet("select count(*) from decision").getInt(), 2)
      << "nothing that was decided is lost";
}

TEST_F(Kept, AWithdrawnDecisionLeavesAFindingUndecidedAndStaysInTheRecord) {
  const std::int64_t id = add();
  records_->set_comparison(id, comparison(1), {}, {finding(1)});
  const int mark = records_->add_mark(id, {});
  const Decision withdrawn{Verdict::undecided, "", "Bob", "t2"};
  records_->decide_all(id, 1,
                       {{1, false, {Verdict::false_alarm, "", "Ann", "t1"}},
                        {mark, true, {Verdict::installed_work, "", "Ann", "t1"}}});
  EXPECT_EQ(records_->summaries({}).at(0).undecided, 0U);
  records_->decide_all(id, 1, {{1, false, withdrawn}, {mark, true, withdrawn}});
  open();
  const Inspection back = *records_->find(id);
  EXPECT_FALSE(back.findings[0].decision || back.marked[0].decision);
  EXPECT_EQ(records_->summaries({}).at(0).undecided, 2U);
  SQLite::Database file((folder_ / "rva.db").string());
  EXPECT_EQ(file.execAndGet("select count(*) from decision").getInt(), 2);
  EXPECT_EQ(file.execAndGet("select count(*) from mark_decision where person = 'Bob'").getInt(), 1);
}

TEST_F(Kept, DecisionsTogetherAreAllRecordedOrNone) {
  const std::int64_t id = add();
  records_->set_comparison(id, comparison(1), {}, {finding(1), finding(2)});
  const Decision decision{Verdict::false_alarm, "", "Ann", "t"};
  EXPECT_THROW(records_->decide_all(id, 1, {{1, false, decision}, {3, false, decision}}), Error);
  EXPECT_THROW(records_->decide_all(id, 1, {{1, false, decision}, {1, true, decision}}), Error);
  EXPECT_THROW(records_->decide_all(id, 2, {{1, false, decision}}), Error) << "not of this comparison";
  EXPECT_FALSE(records_->find(id)->findings[0].decision);
  records_->decide_all(id, 1, {{2, false, decision}, {1, false, decision}});
  EXPECT_TRUE(records_->find(id)->findings[0].decision && records_->find(id)->findings[1].decision);
}

TEST_F(Kept, WhatIsCapturedAnewIsNotCompared) {
  const std::int64_t id = add();
  records_->set_comparison(id, comparison(1), {}, {finding(1)});
  records_->set_side(id, Side::final, {"t", "Ann", "base"});
  const Inspection inspection = *records_->find(id);
  EXPECT_FALSE(inspection.comparison);
  EXPECT_TRUE(inspection.findings.empty());
  EXPECT_THROW(records_->decide(id, 1, 1, {}), Error);
}

TEST_F(Kept, RegionsThatAreLeftOutComeBackAndEndTheComparison) {
  const std::int64_t id = add();
  records_->set_comparison(id, comparison(1), {{0, "spatial", {0.5, 0.1, 0.1, {}, 0.3}, 0.5, {}}},
                           {finding(1)});
  EXPECT_EQ(records_->find(id)->compared.at(0).coverage.left_out, 0.3);
  const Polygon polygon{{0.5, 1}, {3, 1.25}, {2, 7}};
  records_->set_ignored(id, 1, {polygon, polygon});
  records_->set_ignored(id, 1, {polygon});
  open();
  const Inspection back = *records_->find(id);
  EXPECT_EQ(back.ignored, (std::map<int, std::vector<Polygon>>{{1, {polygon}}}));
  EXPECT_FALSE(back.comparison) << "it was made without them";
  EXPECT_TRUE(back.findings.empty());
  EXPECT_THROW(records_->set_ignored(7, 0, {}), Error);
}

TEST_F(Kept, AFindingOfAppearanceIsKeptWithItsEvidence) {
  const std::int64_t id = add();
  ReviewedFinding seen = finding(1);
  seen.finding.kind = ChangeKind::appearance;
  seen.finding.evidence = {.depth = false, .appearance = true};
  records_->set_comparison(id, comparison(1), {}, {seen, finding(2)});
  const Inspection back = *records_->find(id);
  EXPECT_EQ(back.findings[0].finding.kind, ChangeKind::appearance);
  EXPECT_EQ(back.findings[0].finding.evidence, seen.finding.evidence);
  EXPECT_EQ(back.findings[1].finding.evidence, Evidence{});
}

TEST_F(Kept, AThingThatWasMovedNamesWhereItWas) {
  const std::int64_t id = add();
  ReviewedFinding moved = finding(1);
  moved.moved_from = 2;
  records_->set_comparison(id, comparison(1), {}, {moved, finding(2)});
  EXPECT_EQ(records_->find(id)->findings[0].moved_from, 2);
  EXPECT_FALSE(records_->find(id)->findings[1].moved_from);
}

TEST_F(Kept, APlanIsOfItsViewAndMakesAComparisonOutdated) {
  const std::int64_t id = add();
  PlannedItem collars;
  collars.name = "collars";
  collars.count = 2;
  collars.height_mm = {8, 10};
  collars.places = {{{5, 6}}, {{50, 6}}};
  const Plan plan{PlanCoordinates::pixels, {collars}};
  records_->set_comparison(id, comparison(1), {}, {});
  records_->set_plan(id, 1, &plan);
  open();
  EXPECT_EQ(records_->find(id)->planned, (std::map<int, Plan>{{1, plan}}));
  EXPECT_FALSE(records_->find(id)->comparison) << "it was made without the plan";
  records_->set_plan(id, 1, nullptr);
  EXPECT_TRUE(records_->find(id)->planned.empty());
  EXPECT_THROW(records_->set_plan(7, 0, &plan), Error);
  EXPECT_TRUE(records_->find(id)->planned.empty());
}

TEST_F(Kept, AComparisonStatesWhatItFoundOfThePlan) {
  const std::int64_t id = add();
  ReviewedFinding missing = finding(1);
  missing.planned = PlannedState::missing;
  missing.planned_item = "collars";
  const PlannedWork work{"collars", ChangeKind::added, 24, 22, 1, 1};
  ComparedView view;
  view.method = "spatial";
  view.planned = {work};
  records_->set_comparison(id, comparison(1), {view}, {missing, finding(2)});
  open();
  const Inspection back = *records_->find(id);
  EXPECT_THAT(back.compared.at(0).planned, ElementsAre(work));
  EXPECT_EQ(back.findings[0].planned, PlannedState::missing);
  EXPECT_EQ(back.findings[0].planned_item, "collars");
  EXPECT_FALSE(back.findings[1].planned) << "without a plan";
}

TEST_F(Kept, ADecisionKeepsWhatThePersonCalledTheObject) {
  const std::int64_t id = add();
  records_->set_comparison(id, comparison(1), {}, {finding(1), finding(2)});
  records_->decide(id, 1, 1, {Verdict::debris, "", "Ann", "noon", 0, "rag"});
  open();
  EXPECT_EQ(records_->find(id)->findings[0].decision->object, "rag");
  const auto history = records_->history(id);
  ASSERT_EQ(history->decisions.size(), 1U);
  EXPECT_EQ(history->decisions[0].decision.object, "rag");
  EXPECT_EQ(history->decisions[0].finding, 1);
}

// The clock of a computer without a battery stands at one time, or steps back.
TEST_F(Kept, ComparisonsAreDistinguishedByNumbersAtAnyTimeOfTheClock) {
  const std::int64_t id = add();
  records_->set_comparison(id, {1, "noon", "comparison-1"}, {}, {finding(1)});
  records_->decide(id, 1, 1, {Verdict::false_alarm, "", "Ann", "noon"});
  records_->set_comparison(id, {2, "noon", "comparison-2"}, {}, {finding(1)});
  EXPECT_FALSE(records_->find(id)->findings[0].decision);
  EXPECT_THROW(records_->decide(id, 1, 1, {Verdict::false_alarm, "", "Ann", "noon"}), Error);
  EXPECT_EQ(records_->find(id)->comparisons, 2);
}

TEST_F(Kept, AComparisonThatWasBegunIsKnownUntilItIsRecorded) {
  const std::int64_t id = add();
  records_->begin_comparison(id, {1, "", "comparison-1"});
  open();
  EXPECT_THAT(records_->find(id)->unfinished_comparisons, ElementsAre("comparison-1"));
  EXPECT_EQ(records_->find(id)->comparisons, 1) << "its number is not given again";
  EXPECT_FALSE(records_->find(id)->comparison);
  records_->set_comparison(id, comparison(1), {}, {finding(1)});
  EXPECT_TRUE(records_->find(id)->unfinished_comparisons.empty());
  EXPECT_EQ(records_->find(id)->comparison->number, 1);
}

TEST_F(Kept, ARoundUnderWayIsKnownUntilItIsComplete) {
  const std::int64_t id = add();
  records_->begin_side(id, Side::final, {1, "Ann", "base"});
  EXPECT_EQ(records_->find(id)->begun.at(Side::final).round, 1);
  EXPECT_FALSE(records_->find(id)->final);
  records_->set_side(id, Side::final, {"t1", "Ann", "base", 1});
  EXPECT_TRUE(records_->find(id)->begun.empty());
  records_->begin_side(id, Side::final, {2, "Bob", "other"});
  open();
  EXPECT_EQ(records_->find(id)->final->round, 1) << "the earlier round holds until then";
  EXPECT_EQ(records_->find(id)->begun.at(Side::final).base, "other");
  records_->set_side(id, Side::final, {"t2", "Bob", "other", 2});
  EXPECT_EQ(records_->find(id)->final->person, "Bob");
}

}  // namespace
}  // namespace rva
