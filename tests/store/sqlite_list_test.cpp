#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "store/sqlite_records.hpp"
#include "tests/store/kept.hpp"

namespace rva {
namespace {

using test::comparison;
using test::finding;
using test::Kept;
using testing::ElementsAre;
using testing::SizeIs;

TEST_F(Kept, NewestInspectionsComeFirst) {
  const std::int64_t first = add();
  const std::int64_t second = add();
  EXPECT_THAT(records_->inspections(), ElementsAre(second, first));
  EXPECT_FALSE(records_->find(second + 1));
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

}  // namespace
}  // namespace rva
