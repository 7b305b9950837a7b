#include "report/trends.hpp"

#include <gtest/gtest.h>

#include <string>

namespace rva {
namespace {

InspectionHistory inspection(const std::string& zone, const std::string& begun_at,
                             const std::string& closed_at = "") {
  InspectionHistory history;
  history.inspection.order.zone = zone;
  history.inspection.created_at = begun_at;
  if (!closed_at.empty()) history.inspection.closing = Closing{1, "Ida", "", closed_at};
  return history;
}

ComparedRound round_with(std::initializer_list<Verdict> verdicts) {
  ComparedRound round;
  for (const Verdict verdict : verdicts) {
    ReviewedFinding finding;
    finding.number = finding.same_as = static_cast<int>(round.findings.size()) + 1;
    if (verdict != Verdict::undecided) finding.decision = Decision{verdict, "", "", "", 0};
    round.findings.push_back(finding);
  }
  return round;
}

TEST(Trends, AreByZoneAndMonth) {
  Trends trends;
  for (const auto& [zone, begun_at] : {std::pair("b", "2026-01-31T23:59:59.999Z"),
                                       {"b", "2026-02-01T00:00:00.000Z"},
                                       {"a", "2026-02-03T00:00:00.000Z"},
                                       {"b", "2026-02-28T00:00:00.000Z"}})
    add_to(trends, inspection(zone, begun_at));
  ASSERT_EQ(trends.size(), 3U);
  EXPECT_EQ((trends[{"a", "2026-02"}].inspections), 1U);
  EXPECT_EQ((trends[{"b", "2026-01"}].inspections), 1U);
  EXPECT_EQ((trends[{"b", "2026-02"}].inspections), 2U);
  EXPECT_EQ(trends.begin()->first.zone, "a");
  EXPECT_EQ(sum_of(trends).inspections, 4U);
}

TEST(Trends, CountWhatEachComparisonFoundAndWhatPeopleMarked) {
  InspectionHistory history = inspection("a", "2026-01-01T00:00:00.000Z");
  history.rounds = {
      round_with({Verdict::false_alarm, Verdict::undecided}),
      round_with({Verdict::debris_removed, Verdict::installed_work, Verdict::debris_unreachable})};
  MarkedFinding marked;
  marked.decision = Decision{Verdict::debris_removed, "", "", "", 0};
  history.inspection.marked = {marked, MarkedFinding{}};
  Trends trends;
  add_to(trends, history);
  add_to(trends, history);
  const Trend sum = sum_of(trends);
  EXPECT_EQ(sum.comparisons, 4U);
  EXPECT_EQ(sum.found.all(), 10U);
  EXPECT_EQ(sum.found.removed, 2U);
  EXPECT_EQ(sum.found.unreachable, 2U);
  EXPECT_EQ(sum.found.installed, 2U);
  EXPECT_EQ(sum.found.false_alarms, 2U);
  EXPECT_EQ(sum.found.undecided, 2U);
  EXPECT_EQ(sum.marked.removed, 2U);
  EXPECT_EQ(sum.marked.undecided, 2U);
}

TEST(Trends, TheTimeIsThatOfClosedInspections) {
  Trends trends;
  EXPECT_EQ(sum_of(trends).median_hours(), std::nullopt);
  add_to(trends, inspection("a", "2026-01-01T00:00:00.000Z"));
  add_to(trends, inspection("a", "2026-01-01T00:00:00.000Z", "2026-01-01T01:00:00.000Z"));
  add_to(trends, inspection("a", "2026-01-01T00:00:00.000Z", "2026-01-01T00:30:00.000Z"));
  add_to(trends, inspection("b", "2026-01-01T00:00:00.000Z", "2026-01-02T00:00:00.000Z"));
  EXPECT_EQ((trends[{"a", "2026-01"}].median_hours()), 0.5) << "the lower one of two";
  EXPECT_EQ(sum_of(trends).median_hours(), 1.0);
  add_to(trends, inspection("b", "2026-01-02T00:00:00.000Z", "2026-01-01T00:00:00.000Z"));
  EXPECT_EQ(sum_of(trends).closed, 4U);
  EXPECT_EQ(sum_of(trends).hours.size(), 3U) << "a clock that was set back gives no time";
}

}  // namespace
}  // namespace rva
