#include "store/sqlite_records.hpp"

#include <SQLiteCpp/Database.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <memory>

#include "core/error.hpp"
#include "core/file.hpp"
#include "inspect/inspection_folder.hpp"
#include "store/schema.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::SizeIs;

class Kept : public testing::Test {
 protected:
  Kept() { open(); }
  void open() {
    records_.reset();
    records_ = std::make_unique<SqliteRecords>(folder_ / "rva.db");
  }
  std::int64_t add() {
    return records_->add_inspection({"N1", "bay 3", "WO 7", "Ann O'Neil \"x\"; drop table view"},
                                    "2026-01-01T00:00:00Z", 4, {{0, 0}}, 0);
  }

  test::TemporaryFolder folder_;
  std::unique_ptr<SqliteRecords> records_;
};

RecordedComparison comparison(int number) { return {number, "t", InspectionFolder::comparison_name(number)}; }

ReviewedFinding finding(int number) {
  ReviewedFinding reviewed;
  reviewed.number = reviewed.same_as = number;
  reviewed.view = 1;
  reviewed.finding.kind = number % 2 == 0 ? ChangeKind::removed : ChangeKind::added;
  reviewed.finding.box = {1, 2, 3, 4};
  reviewed.finding.centroid = {2.5, 4.25};
  reviewed.finding.position_m = Eigen::Vector3d(0.1, -0.2, 1.0 / 3.0);
  reviewed.in_foot_m = Eigen::Vector3d(1, 2, 3);
  reviewed.finding.size_mm = {7.1, 8.2};
  reviewed.finding.height_mm = 6.9;
  reviewed.finding.above_surroundings_mm = 5.9;
  reviewed.finding.background_jump = true;
  reviewed.finding.top_above_surroundings_mm = 7.5;
  reviewed.finding.top_is_least = true;
  reviewed.clear_px = 120;
  reviewed.finding.score = 9.5;
  reviewed.finding.p_value = 1e-9;
  return reviewed;
}

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
  EXPECT_TRUE(first.background_jump);
  EXPECT_EQ(first.box, (Box{1, 2, 3, 4}));
  EXPECT_EQ(back->findings[1].finding.kind, ChangeKind::removed);
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

TEST_F(Kept, NewestInspectionsComeFirst) {
  const std::int64_t first = add();
  const std::int64_t second = add();
  EXPECT_THAT(records_->inspections(), ElementsAre(second, first));
  EXPECT_FALSE(records_->find(second + 1));
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
  const Plan plan{PlanCoordinates::pixels,
                  {{.name = "collars", .count = 2, .height_mm = {8, 10}, .places = {{{5, 6}}, {{50, 6}}}}}};
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
  ComparedView view{.view = 0, .method = "spatial"};
  view.planned = {work};
  records_->set_comparison(id, comparison(1), {view}, {missing, finding(2)});
  open();
  const Inspection back = *records_->find(id);
  EXPECT_THAT(back.compared.at(0).planned, ElementsAre(work));
  EXPECT_EQ(back.findings[0].planned, PlannedState::missing);
  EXPECT_EQ(back.findings[0].planned_item, "collars");
  EXPECT_FALSE(back.findings[1].planned) << "without a plan";
}

// The program wrote such files before regions could be left out.
TEST_F(Kept, AFileOfVersion1IsBroughtUpToDate) {
  records_.reset();
  const std::filesystem::path old = folder_ / "old.db";
  {
    SQLite::Database file(old.string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE);
    file.exec(schema);
    file.exec("pragma application_id = 1381384497");
    file.exec("pragma user_version = 1");
    file.exec(
        "insert into inspection values (1, 'N1', 'bay', 'WO', 'Ann', 't0', 't1', 4);"
        "insert into side values (1, 'final', 't0', 'Ann', 'base');"
        "insert into account values ('ann', 'viewer', 'h');"
        "insert into compared_view values (1, 0, 'spatial', 0.9, 0.06, 0.04, 0.8, '[]');"
        "insert into finding values (1, 't1', 1, 0, 1, 'added', '[1,2,3,4]', '[2.5,4]', null, null, null, 7, "
        "9, null);"
        "insert into decision values (1, 1, 't1', 1, 'debris-removed', 'a bolt', 'Bob', 't2')");
  }
  SqliteRecords records(old);
  const Inspection back = *records.find(1);
  ASSERT_THAT(back.findings, SizeIs(1));
  EXPECT_EQ(back.findings[0].decision->note, "a bolt");
  EXPECT_EQ(back.comparison->number, 1);
  EXPECT_EQ(back.comparison->compared_at, "t1");
  EXPECT_EQ(back.findings[0].finding.evidence, Evidence{}) << "depth, as all were";
  EXPECT_EQ(back.final->round, 1);
  EXPECT_EQ(back.comparison->final_round, 1);
  EXPECT_EQ(back.findings[0].decision->round, 1);
  EXPECT_EQ(back.compared.at(0).judged, 0.8);
  EXPECT_EQ(records.accounts().at(0).generation.size(), 32U);
  EXPECT_NO_THROW(records.decide(1, 1, 1, {Verdict::false_alarm, "", "Ann", "t3"}));
  EXPECT_NO_THROW(records.set_comparison(1, comparison(2), {}, {finding(1)}));
  EXPECT_FALSE(back.findings[0].moved_from || back.compared.at(0).coverage.left_out);
  EXPECT_TRUE(back.ignored.empty() && back.planned.empty() && back.compared.at(0).planned.empty());
  EXPECT_NO_THROW(records.set_ignored(1, 0, {{{0, 0}, {1, 0}, {0, 1}}}));
  EXPECT_THAT(records.summaries({.text = "bay n1"}), SizeIs(1));
  EXPECT_EQ(records.add_inspection({}, "t4", 1, {{0, 0}}, 0), 2);
  EXPECT_NO_THROW(SqliteRecords{old}) << "once";
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

TEST_F(Kept, AnInspectionsIdIsAboveThoseOfFoldersThatAreThere) {
  EXPECT_EQ(records_->add_inspection({}, "t", 1, {{0, 0}}, 7), 8);
  EXPECT_EQ(records_->add_inspection({}, "t", 1, {{0, 0}}, 3), 9);
}

TEST_F(Kept, AnIdIsNeverGivenAgain) {
  const std::int64_t first = add();
  const std::int64_t second = add();
  records_->remove(second);
  open();
  EXPECT_EQ(add(), second + 1);
  records_->remove(second + 1);
  records_->remove(first);
  EXPECT_EQ(add(), second + 2) << "also if none is left";
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

TEST_F(Kept, TheListAgreesWithEachInspection) {
  const auto list = [this] {
    std::vector<InspectionSummary> all = records_->summaries({});
    for (const InspectionSummary& summary : all) {
      const InspectionSummary whole = summary_of(*records_->find(summary.id));
      EXPECT_EQ(summary.stage, whole.stage) << summary.id;
      EXPECT_EQ(summary.findings, whole.findings) << summary.id;
      EXPECT_EQ(summary.undecided, whole.undecided) << summary.id;
      EXPECT_EQ(summary.order.person, whole.order.person) << summary.id;
      EXPECT_EQ(summary.final ? summary.final->round : 0, whole.final ? whole.final->round : 0) << summary.id;
    }
    return all;
  };
  const std::int64_t id = add();
  add();
  EXPECT_EQ(list().at(1).stage, Stage::baseline);
  records_->set_side(id, Side::initial, {"t", "Ann", "base"});
  EXPECT_EQ(list().at(1).stage, Stage::work);
  records_->set_side(id, Side::final, {"t", "Ann", "base", 2});
  records_->begin_side(id, Side::final, {3, "Ann", "base"});
  records_->set_comparison(id, comparison(1), {{0, "static", {1, 0, 0, {}}, 1, {}}},
                           {finding(1), finding(2)});
  EXPECT_EQ(list().at(1).undecided, 2U);
  records_->decide(id, 1, 1, {Verdict::false_alarm, "", "Ann", "t"});
  records_->decide(id, 1, 2, {Verdict::false_alarm, "", "Ann", "t"});
  EXPECT_EQ(list().at(1).stage, Stage::review) << "nobody has closed it";
  EXPECT_EQ(list().at(1).undecided, 0U);
  for (const Verdict verdict : {Verdict::second_look, Verdict::debris}) {
    records_->decide(id, 1, 2, {verdict, "", "Ann", "t"});
    EXPECT_EQ(list().at(1).undecided, 1U);
  }
  EXPECT_EQ(records_->add_mark(id, {.box = {1, 2, 3, 4}}), 1);
  EXPECT_EQ(list().at(1).undecided, 2U);
  records_->decide_mark(id, 1, {Verdict::installed_work, "", "Ann", "t"});
  records_->decide(id, 1, 2, {Verdict::debris_unreachable, "", "Ann", "t"});
  EXPECT_EQ(list().at(1).undecided, 0U);
  EXPECT_THROW(records_->close(id, {1, "Ann", "a note", "t"}), Error) << "a round is under way";
  records_->set_side(id, Side::final, {"t", "Ann", "base", 3});
  records_->set_comparison(id, comparison(2), {{0, "static", {1, 0, 0, {}}, 1, {}}}, {});
  records_->close(id, {2, "Ann", "a note", "t"});
  EXPECT_EQ(list().at(1).stage, Stage::done);
  EXPECT_EQ(list().at(1).closing->person, "Ann");
}

TEST_F(Kept, AListIsFilteredByWordsStageTimeAndNumber) {
  const auto add_of = [&](const std::string& aircraft, const std::string& zone, const std::string& at) {
    return records_->add_inspection({aircraft, zone, "WO_7", "Ann"}, at, 1, {{0, 0}}, 0);
  };
  const std::int64_t first = add_of("N1", "left wing", "2026-01-01T10:00:00Z");
  const std::int64_t second = add_of("N2", "right wing", "2026-01-02T10:00:00Z");
  const std::int64_t third = add_of("N1", "100% tail", "2026-01-03T10:00:00Z");
  records_->set_side(second, Side::initial, {"t", "Ann", "base"});
  const auto ids = [&](const InspectionFilter& filter) {
    std::vector<std::int64_t> found;
    for (const InspectionSummary& summary : records_->summaries(filter)) found.push_back(summary.id);
    return found;
  };
  EXPECT_THAT(ids({}), ElementsAre(third, second, first));
  EXPECT_THAT(ids({.text = "WING"}), ElementsAre(second, first)) << "in any case";
  EXPECT_THAT(ids({.text = " wing  n1 "}), ElementsAre(first)) << "every word, wherever it is";
  EXPECT_THAT(ids({.text = "0%"}), ElementsAre(third)) << "literally";
  EXPECT_THAT(ids({.text = "WO_"}), SizeIs(3));
  EXPECT_THAT(ids({.text = "W_7"}), SizeIs(0)) << "an underscore stands for itself";
  EXPECT_THAT(ids({.text = "\\"}), SizeIs(0));
  EXPECT_THAT(ids({.text = "' or 1=1 --"}), SizeIs(0));
  EXPECT_THAT(ids({.stage = Stage::work}), ElementsAre(second));
  EXPECT_THAT(ids({.stage = Stage::done}), SizeIs(0));
  EXPECT_THAT(ids({.from = "2026-01-02"}), ElementsAre(third, second));
  EXPECT_THAT(ids({.until = "2026-01-02"}), ElementsAre(first));
  EXPECT_THAT(ids({.before = third, .most = 1}), ElementsAre(second));
  EXPECT_THAT(ids({.text = "n", .before = third, .most = 1}), ElementsAre(second));
  EXPECT_THAT(ids({.text = "ann", .stage = Stage::work}), ElementsAre(second));
  records_->remove(first);
  EXPECT_THAT(ids({.text = "wing"}), ElementsAre(second));
}

TEST_F(Kept, AMarkComesBackAsItWas) {
  const std::int64_t id = add();
  MarkedFinding marked;
  marked.view = 1;
  marked.comparison = 3;
  marked.round = 2;
  marked.picture = "marks/001.png";
  marked.box = {1, 2, 3, 4};
  marked.position_m = Eigen::Vector3d(0.1, -0.2, 1.0 / 3.0);
  marked.in_foot_m = Eigen::Vector3d(1, 2, 3);
  marked.size_mm = {7.1, 8.2};
  marked.note = "a \"washer\"; drop table mark";
  marked.person = "Ann";
  marked.marked_at = "t1";
  EXPECT_EQ(records_->add_mark(id, marked), 1);
  EXPECT_EQ(records_->add_mark(id, {.box = {0, 0, 1, 1}}), 2);
  records_->decide_mark(id, 1, {Verdict::second_look, "?", "Ann", "t2", 1});
  records_->decide_mark(id, 1, {Verdict::debris, "!", "Bob", "t3", 2});
  open();
  const std::vector<MarkedFinding> back = records_->find(id)->marked;
  ASSERT_THAT(back, SizeIs(2));
  EXPECT_EQ(back[0].view, 1);
  EXPECT_EQ(back[0].comparison, 3);
  EXPECT_EQ(back[0].round, 2);
  EXPECT_EQ(back[0].picture, marked.picture);
  EXPECT_EQ(back[0].box, marked.box);
  EXPECT_EQ(back[0].position_m, marked.position_m);
  EXPECT_EQ(back[0].in_foot_m, marked.in_foot_m);
  EXPECT_EQ(back[0].size_mm, marked.size_mm);
  EXPECT_EQ(back[0].note, marked.note);
  EXPECT_EQ(back[0].marked_at, "t1");
  EXPECT_EQ(back[0].decision->verdict, Verdict::debris);
  EXPECT_EQ(back[0].decision->round, 2);
  EXPECT_FALSE(back[1].view || back[1].position_m || back[1].size_mm || back[1].decision);
  EXPECT_THROW(records_->decide_mark(id, 3, {}), Error);
  EXPECT_THROW(static_cast<void>(records_->add_mark(id + 1, {})), Error);
}

TEST_F(Kept, SnapshotsAreNoFindings) {
  const std::int64_t id = add();
  EXPECT_EQ(records_->add_snapshot(id, {0, "snapshots/001.png", "a \"crack\"?", "Ann", "t1"}), 1);
  EXPECT_EQ(records_->add_snapshot(id, {0, "snapshots/002.png", "", "Bob", "t2"}), 2);
  open();
  const std::vector<Snapshot> back = records_->find(id)->snapshots;
  ASSERT_THAT(back, SizeIs(2));
  EXPECT_EQ(back[0].picture, "snapshots/001.png");
  EXPECT_EQ(back[0].note, "a \"crack\"?");
  EXPECT_EQ(back[0].person, "Ann");
  EXPECT_EQ(back[0].taken_at, "t1");
  EXPECT_EQ(back[1].number, 2);
  EXPECT_EQ(records_->summaries({}).at(0).findings, 0U);
  EXPECT_THROW(static_cast<void>(records_->add_snapshot(id + 1, {})), Error);
  EXPECT_THROW(records_->remove(id), Error) << "snapshots are kept";
}

TEST_F(Kept, AClosedInspectionDoesNotChange) {
  const std::int64_t id = add();
  records_->set_side(id, Side::initial, {"t", "Ann", "base"});
  records_->set_side(id, Side::final, {"t", "Ann", "base"});
  records_->set_comparison(id, comparison(1), {{0, "static", {1, 0, 0, {}}, 1, {}}}, {finding(1)});
  EXPECT_THROW(records_->close(id, {1, "Ann", "", "t"}), Error) << "something is undecided";
  records_->decide(id, 1, 1, {Verdict::installed_work, "", "Ann", "t"});
  records_->close(id, {1, "Ann", "", "t"});
  open();
  EXPECT_EQ(records_->find(id)->closing->person, "Ann");
  EXPECT_THROW(records_->close(id, {1, "Bob", "", "t"}), Error);
  EXPECT_THROW(records_->decide(id, 1, 1, {Verdict::debris, "", "Ann", "t"}), Error);
  EXPECT_THROW(records_->set_views(id, {{1, 1}}), Error);
  EXPECT_THROW(records_->set_ignored(id, 0, {}), Error);
  EXPECT_THROW(records_->begin_side(id, Side::final, {2, "Ann", "base"}), Error);
  EXPECT_THROW(records_->set_side(id, Side::final, {"t", "Ann", "base", 2}), Error);
  EXPECT_THROW(records_->begin_comparison(id, comparison(2)), Error);
  EXPECT_THROW(static_cast<void>(records_->add_mark(id, {})), Error);
  EXPECT_THROW(static_cast<void>(records_->add_snapshot(id, {})), Error);
  EXPECT_THROW(records_->remove(id), Error);
  EXPECT_EQ(records_->find(id)->findings.at(0).decision->verdict, Verdict::installed_work);
}

TEST_F(Kept, EarlierComparisonsStayWithTheirCoverageFindingsAndDecisions) {
  const std::int64_t id = add();
  records_->set_side(id, Side::final, {"t", "Ann", "base", 1});
  records_->set_comparison(id, {1, "noon", "comparison-1", 1}, {{0, "spatial", {0.9, 0, 0, {}}, 0.6, {"w"}}},
                           {finding(1), finding(2)});
  records_->decide(id, 1, 2, {Verdict::debris_removed, "a collar", "Bob", "t2", 1});
  records_->begin_comparison(id, {2, "", "comparison-2", 1});
  records_->set_side(id, Side::final, {"t", "Bob", "base", 2});
  records_->set_comparison(id, {3, "noon", "comparison-3", 2}, {{0, "spatial", {0.8, 0, 0, {}}, 0.5, {}}},
                           {});
  open();
  EXPECT_EQ(records_->comparison(id, 1)->folder, "comparison-1");
  EXPECT_FALSE(records_->comparison(id, 2)) << "it was not completed";
  EXPECT_FALSE(records_->comparison(id, 4) || records_->comparison(id + 1, 1));
  const std::vector<ComparedRound> rounds = records_->rounds(id);
  ASSERT_THAT(rounds, SizeIs(2)) << "the one that was not completed shows nothing";
  EXPECT_EQ(rounds[0].comparison.number, 3);
  EXPECT_EQ(rounds[0].final->person, "Bob");
  EXPECT_EQ(rounds[0].compared.at(0).judged, 0.5);
  EXPECT_EQ(rounds[1].comparison.folder, "comparison-1");
  EXPECT_EQ(rounds[1].final->person, "Ann");
  EXPECT_EQ(rounds[1].compared.at(0).judged, 0.6);
  EXPECT_THAT(rounds[1].compared.at(0).warnings, ElementsAre("w"));
  ASSERT_THAT(rounds[1].findings, SizeIs(2));
  EXPECT_EQ(rounds[1].findings[1].decision->note, "a collar");
  EXPECT_EQ(rounds[1].findings[1].decision->round, 1);
}

TEST_F(Kept, AHistoryHasEveryRoundAndDecision) {
  const std::int64_t id = add();
  records_->set_side(id, Side::initial, {"t1", "Ann", "base"});
  records_->begin_side(id, Side::final, {1, "Ann", "base"});
  records_->set_side(id, Side::final, {"t2", "Bob", "base", 2});
  records_->set_comparison(id, comparison(1), {}, {finding(1)});
  records_->decide(id, 1, 1, {Verdict::second_look, "?", "Ann", "t3", 2});
  records_->decide(id, 1, 1, {Verdict::false_alarm, "", "Bob", "t4", 2});
  const int mark = records_->add_mark(id, {});
  records_->decide_mark(id, mark, {Verdict::debris, "", "Ann", "t5", 2});
  records_->set_comparison(id, comparison(2), {}, {});
  const InspectionHistory history = *records_->history(id);
  EXPECT_EQ(history.inspection.id, id);
  ASSERT_THAT(history.captured, SizeIs(2)) << "a round that is not complete has none";
  EXPECT_EQ(history.captured[0].side, Side::initial);
  EXPECT_EQ(history.captured[1].taken.round, 2);
  EXPECT_EQ(history.captured[1].taken.person, "Bob");
  ASSERT_THAT(history.rounds, SizeIs(2));
  EXPECT_THAT(history.rounds[1].findings, SizeIs(1));
  ASSERT_THAT(history.decisions, SizeIs(3));
  EXPECT_EQ(history.decisions[0].decision.note, "?");
  EXPECT_EQ(history.decisions[1].comparison, 1);
  EXPECT_EQ(history.decisions[1].decision.verdict, Verdict::false_alarm);
  EXPECT_EQ(history.decisions[2].comparison, 0);
  EXPECT_EQ(history.decisions[2].finding, mark);
  EXPECT_FALSE(records_->history(id + 1));
}

TEST_F(Kept, WhatIsNotThereCannotBeChanged) {
  EXPECT_THROW(records_->set_views(7, {{0, 0}}), Error);
  EXPECT_THROW(records_->set_side(7, Side::initial, {}), Error);
  EXPECT_THROW(records_->set_comparison(7, comparison(1), {}, {}), Error);
  const std::int64_t id = add();
  EXPECT_THROW(records_->decide(id, 1, 1, {}), Error);
}

TEST_F(Kept, AFailedChangeLeavesAllAsItWas) {
  const std::int64_t id = add();
  records_->set_comparison(id, comparison(1), {}, {finding(1)});
  EXPECT_THROW(records_->set_comparison(id, comparison(2), {}, {finding(1), finding(1)}), Error)
      << "a number twice";
  EXPECT_EQ(records_->find(id)->comparison->number, 1);
  EXPECT_THAT(records_->find(id)->findings, SizeIs(1));
}

TEST_F(Kept, AccountsAreAddedReplacedAndRemoved) {
  records_->set_account({"ann", PersonRole::viewer, "h1"});
  records_->set_account({"ann", PersonRole::inspector, "h2"});
  ASSERT_THAT(records_->accounts(), SizeIs(1));
  EXPECT_EQ(records_->accounts()[0].role, PersonRole::inspector);
  const std::string generation = records_->accounts()[0].generation;
  records_->set_account({"ann", PersonRole::inspector, "h2"});
  EXPECT_NE(records_->accounts()[0].generation, generation);
  EXPECT_TRUE(records_->remove_account("ann"));
  EXPECT_FALSE(records_->remove_account("ann"));
}

// As a power cut would: nothing of the process is left to tidy up.
TEST_F(Kept, WhatWasSaidToBeDoneSurvivesAKill) {
  records_.reset();
  const pid_t child = ::fork();
  if (child == 0) {
    SqliteRecords records(folder_ / "rva.db");
    for (int i = 0; i < 3; ++i)
      static_cast<void>(records.add_inspection({"", "", "", "Ann"}, "t", 1, {{0, 0}}, 0));
    ::kill(::getpid(), SIGKILL);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  ASSERT_TRUE(WIFSIGNALED(status));
  open();
  EXPECT_THAT(records_->inspections(), SizeIs(3));
}

std::string refusal(const std::filesystem::path& file) {
  try {
    const SqliteRecords records(file);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

TEST(SqliteRecords, RefusesWhatIsNoDatabaseOfOurs) {
  const test::TemporaryFolder folder;
  write_file(folder / "text.db", "no database at all, but long enough to be looked at as one by a reader");
  EXPECT_THAT(refusal(folder / "text.db"), HasSubstr("text.db"));
  SQLite::Database((folder / "other.db").string(), SQLite::OPEN_READWRITE | SQLite::OPEN_CREATE)
      .exec("create table t (x)");
  EXPECT_THAT(refusal(folder / "other.db"), HasSubstr("another program"));
  EXPECT_THAT(refusal(folder / "missing" / "rva.db"), HasSubstr("rva.db"));
  { const SqliteRecords records(folder / "newer.db"); }
  SQLite::Database((folder / "newer.db").string(), SQLite::OPEN_READWRITE).exec("pragma user_version = 99");
  EXPECT_THAT(refusal(folder / "newer.db"), HasSubstr("newer version"));
}

}  // namespace
}  // namespace rva
