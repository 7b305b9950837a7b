#include "report/report_words.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>

namespace rva {
namespace {

TEST(ReportWords, Times) {
  EXPECT_EQ(time_text("2026-01-02T03:04:05.678Z"), "2026-01-02 03:04 UTC");
  EXPECT_EQ(time_text("yesterday"), "yesterday");
  EXPECT_EQ(time_text(""), "");
}

TEST(ReportWords, NumbersAndLists) {
  EXPECT_EQ(percent_text(0.764), "76 %");
  EXPECT_EQ(percent_text(0.0), "0 %");
  EXPECT_EQ(percent_text(1.0), "100 %");
  EXPECT_EQ(counted(1, "finding", "findings"), "1 finding");
  EXPECT_EQ(counted(0, "finding", "findings"), "0 findings");
  EXPECT_EQ(listed({}), "");
  EXPECT_EQ(listed({"1"}), "1");
  EXPECT_EQ(listed({"1", "2"}), "1 and 2");
  EXPECT_EQ(listed({"1", "2", "5"}), "1, 2 and 5");
}

TEST(ReportWords, Counts) {
  VerdictCounts counts;
  EXPECT_EQ(counts_text(counts), "nothing found");
  for (const Verdict verdict :
       {Verdict::debris_removed, Verdict::debris_removed, Verdict::false_alarm, Verdict::debris,
        Verdict::debris_unreachable, Verdict::installed_work, Verdict::second_look})
    counts.count(Decision{verdict, "", "", "", 0});
  counts.count(std::nullopt);
  EXPECT_EQ(counts.all(), 8U);
  EXPECT_EQ(
      counts_text(counts),
      "2 debris removed, 1 debris left, 1 debris out of reach, 1 installed work, 1 false alarm, 2 undecided");
}

TEST(ReportWords, MeasuresAreThoseThatAreKnown) {
  Finding finding;
  EXPECT_EQ(measures_text(finding), "");
  finding.size_mm = {34.4, 7.26};
  finding.position_m = Eigen::Vector3d(0.1, 0.2, 0.714);
  finding.height_mm = 42.0;
  EXPECT_EQ(measures_text(finding), "34 mm × 7.3 mm, 0.71 m away, surface 42 mm nearer than before");
  finding.above_surroundings_mm = 12.0;
  EXPECT_EQ(measures_text(finding), "34 mm × 7.3 mm, 0.71 m away, 12 mm above its surroundings");
  finding.top_above_surroundings_mm = 8.0;
  finding.top_is_least = true;
  finding.background_jump = true;
  EXPECT_EQ(measures_text(finding),
            "34 mm × 7.3 mm, 0.71 m away, at least 8.0 mm high, at an edge, where the background jumps");
  finding.kind = ChangeKind::removed;
  EXPECT_NE(measures_text(finding).find("at least 8.0 mm high before"), std::string::npos);
}

TEST(ReportWords, AClassIsAHintWhereItIsKnown) {
  ReviewedFinding finding;
  EXPECT_EQ(class_text(finding), "") << "of an earlier version";
  finding.likely_class = "drill bit";
  finding.class_probability = 0.879;
  EXPECT_EQ(class_text(finding), "may be: drill bit (87 %)");
  finding.likely_class = "unknown";
  EXPECT_EQ(class_text(finding), "");
}

TEST(ReportWords, ChangesAccordingToThePlan) {
  ReviewedFinding finding;
  EXPECT_EQ(change_text(finding), "Added");
  finding.finding.kind = ChangeKind::removed;
  EXPECT_EQ(change_text(finding), "Removed");
  finding.planned_item = "collars";
  finding.planned = PlannedState::unplanned;
  EXPECT_EQ(change_text(finding), "Removed");
  finding.planned = PlannedState::missing;
  EXPECT_EQ(change_text(finding), "Missing: collars");
  finding.planned = PlannedState::surplus;
  EXPECT_EQ(change_text(finding), "Removed, beyond the planned collars");
}

}  // namespace
}  // namespace rva
