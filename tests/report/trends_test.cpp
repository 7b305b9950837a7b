#include "report/trends.hpp"

#include <gtest/gtest.h>

#include <string>

namespace rva {
namespace {

InspectionTally inspection(const std::string& zone, const std::string& begun_at,
                           const std::string& closed_at = "") {
  return {1, zone, begun_at, closed_at, 0, {}, {}, {}};
}

TEST(Trends, AreByZoneAndMonth) {
  const Trends trends =
      trends_of({inspection("b", "2026-01-31T23:59:59.999Z"), inspection("b", "2026-02-01T00:00:00.000Z"),
                 inspection("a", "2026-02-03T00:00:00.000Z"), inspection("b", "2026-02-28T00:00:00.000Z")});
  ASSERT_EQ(trends.size(), 3U);
  EXPECT_EQ((trends.at({"a", "2026-02"}).inspections), 1U);
  EXPECT_EQ((trends.at({"b", "2026-01"}).inspections), 1U);
  EXPECT_EQ((trends.at({"b", "2026-02"}).inspections), 2U);
  EXPECT_EQ(trends.begin()->first.zone, "a");
  EXPECT_EQ(sum_of(trends).inspections, 4U);
  EXPECT_EQ(by_month(trends).at("2026-02").inspections, 3U);
  EXPECT_EQ(by_zone(trends).at("b").inspections, 3U);
}

TEST(Trends, AddWhatInspectionsShowed) {
  InspectionTally tally = inspection("a", "2026-01-01T00:00:00.000Z");
  tally.comparisons = 2;
  tally.found = {
      .debris = 1, .removed = 2, .unreachable = 3, .installed = 4, .false_alarms = 5, .undecided = 6};
  tally.marked = {
      .debris = 0, .removed = 1, .unreachable = 0, .installed = 0, .false_alarms = 0, .undecided = 1};
  tally.debris_by_name = {{"", 6}, {"collar", 1}};
  const Trend sum = sum_of(trends_of({tally, tally}));
  EXPECT_EQ(sum.comparisons, 4U);
  EXPECT_EQ(sum.found, (VerdictCounts{2, 4, 6, 8, 10, 12}));
  EXPECT_EQ(sum.found.all(), 42U);
  EXPECT_EQ(sum.decided(), 30U);
  EXPECT_EQ(sum.marked, (VerdictCounts{0, 2, 0, 0, 0, 2}));
  EXPECT_EQ(sum.debris_by_name, (std::map<std::string, std::size_t>{{"", 12}, {"collar", 2}}));
}

TEST(Trends, TheTimeIsThatOfClosedInspections) {
  EXPECT_EQ(sum_of({}).median_hours(), std::nullopt);
  std::vector<InspectionTally> tallies{
      inspection("a", "2026-01-01T00:00:00.000Z"),
      inspection("a", "2026-01-01T00:00:00.000Z", "2026-01-01T01:00:00.000Z"),
      inspection("a", "2026-01-01T00:00:00.000Z", "2026-01-01T00:30:00.000Z"),
      inspection("b", "2026-01-01T00:00:00.000Z", "2026-01-02T00:00:00.000Z")};
  const Trends trends = trends_of(tallies);
  EXPECT_EQ((trends.at({"a", "2026-01"}).median_hours()), 0.5) << "the lower one of two";
  EXPECT_EQ(sum_of(trends).median_hours(), 1.0);
  tallies.push_back(inspection("b", "2026-01-02T00:00:00.000Z", "2026-01-01T00:00:00.000Z"));
  EXPECT_EQ(sum_of(trends_of(tallies)).closed, 4U);
  EXPECT_EQ(sum_of(trends_of(tallies)).hours.size(), 3U) << "a clock that was set back gives no time";
}

}  // namespace
}  // namespace rva
