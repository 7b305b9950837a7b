#include "evaluate/planned_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/error.hpp"

namespace rva {
namespace {

using testing::HasSubstr;

PlannedInspection inspection(bool missing, bool lost, int others) {
  PlannedInspection done;
  done.parts = 21;
  done.with_places = {.missing_reported = missing, .lost_reported = lost, .grouped = 20, .others = others};
  return done;
}

TEST(PlannedStudy, TableCountsWhatWasReportedTogether) {
  const std::string table =
      to_table({inspection(true, true, 0), inspection(true, false, 1), inspection(false, true, 2)});
  const std::string row = table.substr(table.find("with places"));
  EXPECT_THAT(row, testing::ContainsRegex("2/3 .*2/3 .*1/3 .*2/3 .*60/60"));
  EXPECT_THAT(table.substr(table.find("by count")), HasSubstr("0/3"));
}

TEST(PlannedStudy, JsonHasEachInspection) {
  const nlohmann::ordered_json json = json_of({inspection(true, true, 0)});
  EXPECT_EQ(json.at("format"), "rva-evaluation-planned");
  EXPECT_EQ(json.at("inspections").at(0).at("with_places").at("missing_reported"), true);
  EXPECT_EQ(json.at("inspections").at(0).at("by_count").at("lost_reported"), false);
}

TEST(PlannedStudy, RefusesOptionsOutOfRange) {
  StudyOptions options;
  options.inspections = 0;
  EXPECT_THROW((void)run_planned_study(options, {}), UsageError);
}

}  // namespace
}  // namespace rva
