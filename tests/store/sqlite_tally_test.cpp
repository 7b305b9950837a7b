#include <gtest/gtest.h>

#include <set>

#include "store/sqlite_records.hpp"
#include "tests/store/kept.hpp"

namespace rva {
namespace {

using test::comparison;
using test::finding;

bool is_debris(const std::optional<Decision>& decision) {
  return decision && (decision->verdict == Verdict::debris || decision->verdict == Verdict::debris_removed ||
                      decision->verdict == Verdict::debris_unreachable);
}

// What the tally of an inspection must be, from all that the records contain of it.
InspectionTally tally_of(const InspectionHistory& history) {
  const Inspection& inspection = history.inspection;
  InspectionTally tally{.id = inspection.id,
                        .zone = inspection.order.zone,
                        .created_at = inspection.created_at,
                        .closed_at = inspection.closing ? inspection.closing->closed_at : "",
                        .comparisons = history.rounds.size(),
                        .found = {},
                        .marked = {},
                        .debris_by_name = {}};
  const auto count = [&](VerdictCounts& counts, const std::optional<Decision>& decision) {
    counts.count(decision);
    if (is_debris(decision)) ++tally.debris_by_name[decision->object];
  };
  for (const ComparedRound& round : history.rounds) {
    std::set<int> counted;
    for (const ReviewedFinding& found : round.findings)
      if (counted.insert(found.same_as).second) count(tally.found, found.decision);
  }
  for (const MarkedFinding& marked : inspection.marked) count(tally.marked, marked.decision);
  return tally;
}

class Tallied : public test::Kept {
 protected:
  void compare(std::int64_t id, int number, const std::vector<int>& same_as) {
    std::vector<ReviewedFinding> findings;
    for (const int object : same_as) {
      findings.push_back(finding(static_cast<int>(findings.size()) + 1));
      findings.back().same_as = object;
    }
    records_->begin_comparison(id, {number, "", comparison(number).folder});
    records_->set_comparison(id, comparison(number), {{0, "static", {1, 0, 0, {}}, 1, {}}}, findings);
  }
  void decide(std::int64_t id, int comparison, int finding, Verdict verdict, const std::string& object = "") {
    records_->decide(id, comparison, finding, {verdict, "", "Ann", "t", 1, object});
  }
  void expect_as_in_histories() {
    const std::vector<InspectionTally> tallies = records_->tallies({});
    const std::vector<std::int64_t> ids = records_->inspections();
    ASSERT_EQ(tallies.size(), ids.size());
    for (std::size_t i = 0; i < ids.size(); ++i) {
      const InspectionTally wanted = tally_of(*records_->history(ids[i]));
      EXPECT_EQ(tallies[i].id, wanted.id);
      EXPECT_EQ(tallies[i].zone, wanted.zone);
      EXPECT_EQ(tallies[i].created_at, wanted.created_at);
      EXPECT_EQ(tallies[i].closed_at, wanted.closed_at);
      EXPECT_EQ(tallies[i].comparisons, wanted.comparisons) << wanted.id;
      EXPECT_EQ(tallies[i].found, wanted.found) << wanted.id;
      EXPECT_EQ(tallies[i].marked, wanted.marked) << wanted.id;
      EXPECT_EQ(tallies[i].debris_by_name, wanted.debris_by_name) << wanted.id;
    }
  }
};

TEST_F(Tallied, WhatTheHistoriesContain) {
  const std::int64_t id = add();
  const std::int64_t other = add();
  expect_as_in_histories();

  compare(id, 1, {1, 2, 1, 4, 2});
  compare(other, 1, {1});
  decide(id, 1, 1, Verdict::false_alarm);
  decide(id, 1, 3, Verdict::debris);  // not the most suspicious finding of its object
  decide(id, 1, 2, Verdict::debris_removed, "collar");
  decide(id, 1, 4, Verdict::installed_work);
  decide(id, 1, 4, Verdict::undecided);
  expect_as_in_histories();
  EXPECT_EQ(records_->tallies({}).at(1).found, (VerdictCounts{0, 1, 0, 0, 1, 1}));

  compare(id, 2, {1, 2});
  decide(id, 2, 1, Verdict::debris_unreachable, "collar");
  decide(id, 2, 2, Verdict::debris);
  records_->begin_comparison(other, {2, "", "begun"});
  MarkedFinding marked;
  marked.note = "seen";
  const int mark = records_->add_mark(other, marked);
  EXPECT_GT(records_->add_mark(other, marked), mark);
  records_->decide_mark(other, mark, {Verdict::debris_removed, "", "Ann", "t", 1, "rag"});
  expect_as_in_histories();
  const InspectionTally tally = records_->tallies({}).at(1);
  EXPECT_EQ(tally.comparisons, 2U);
  EXPECT_EQ(tally.debris_by_name, (std::map<std::string, std::size_t>{{"", 1}, {"collar", 2}}));
}

TEST_F(Tallied, ThoseOfAFilter) {
  const std::int64_t id = add();
  compare(id, 1, {1});
  compare(add(), 1, {1, 2});
  const std::vector<InspectionTally> tallies = records_->tallies({.before = id + 1});
  ASSERT_EQ(tallies.size(), 1U);
  EXPECT_EQ(tallies[0].id, id);
  EXPECT_EQ(tallies[0].found.undecided, 1U);
  EXPECT_TRUE(records_->tallies({.text = "nowhere"}).empty());
}

}  // namespace
}  // namespace rva
