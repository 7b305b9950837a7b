#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/error.hpp"
#include "store/sqlite_records.hpp"
#include "tests/store/kept.hpp"

namespace rva {
namespace {

using test::comparison;
using test::finding;
using test::Kept;
using testing::ElementsAre;
using testing::SizeIs;

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

}  // namespace
}  // namespace rva
