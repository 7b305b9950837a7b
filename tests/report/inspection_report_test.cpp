#include "report/inspection_report.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "core/file.hpp"
#include "depth/image_file.hpp"
#include "tests/temporary_folder.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

constexpr const char* noon = "2026-01-01T12:00:00.000Z";
constexpr const char* made_at = "2026-01-02T00:00:00.000Z";
constexpr ColorImage::Value bright{90, 120, 150};

std::size_t count(std::string_view text, std::string_view part) {
  std::size_t found = 0;
  for (std::size_t at = text.find(part); at != std::string_view::npos; at = text.find(part, at + 1)) ++found;
  return found;
}

bool contains(const std::string& text, std::string_view part) { return text.find(part) != std::string::npos; }

/// A data folder with one inspection: a view in which one object was found and decided on.
class InspectionReport : public testing::Test {
 protected:
  InspectionReport() {
    Inspection& inspection = history_.inspection;
    inspection.id = 7;
    inspection.order = {"N1 <script>", "bay & 3", "WO \"5\"", "Ann"};
    inspection.created_at = noon;
    inspection.views = {{}};
    inspection.comparison = RecordedComparison{1, noon, "comparison-1", 1};
    ComparedView view;
    view.judged = 0.75;
    view.method = "calibrated";
    view.coverage.invalid = 0.2;
    view.warnings = {"the <camera> moved"};
    view.findable = {{5.0, 0.4}, {10.0, 0.7}, {20.0, 0.75}};
    inspection.compared = {view};
    ReviewedFinding finding;
    finding.number = 1;
    finding.same_as = 1;
    finding.finding.box = {20, 20, 12, 8};
    finding.finding.size_mm = {12.0, 8.0};
    finding.decision = Decision{Verdict::installed_work, "as <planned>", "Bob", noon, 1};
    inspection.findings = {finding};
    history_.rounds = {{*inspection.comparison, std::nullopt, inspection.compared, inspection.findings}};
    history_.decisions = {{1, 1, *finding.decision}};
    write_result();
  }

  [[nodiscard]] InspectionFolder folder() const { return {data_.path(), 7}; }
  [[nodiscard]] fs::path result() const { return folder().path() / "comparison-1" / "results" / "000"; }
  [[nodiscard]] std::string report() const { return inspection_report(history_, folder(), made_at); }

  void write_result() const {
    fs::create_directories(result());
    ASSERT_EQ(result(), InspectionFolder::result_in(folder().path() / "comparison-1", 0));
    for (const char* const name : {"initial_color", "final_color", "initial_depth", "final_depth"})
      write_file(result() / (std::string(name) + ".png"), encode_png(ColorImage(96, 64, bright)));
    write_file(result() / "not_inspected.png", encode_png(ColorImage(96, 64)));
    write_file(result() / "detections.json",
               R"({"method": "calibrated", "parameters": {"false_alarms": 0.05}})");
  }

  test::TemporaryFolder data_;
  InspectionHistory history_;
};

TEST_F(InspectionReport, StatesVerdictCoverageFindingsPeopleAndSettings) {
  history_.inspection.closing = Closing{1, "Ida", "bay is <clean>", noon};
  const std::string page = report();
  for (const char* const part :
       {"No debris remains in what was inspected", "Ida</bdi>, 2026-01-01 12:00 UTC.", "bay is &lt;clean&gt;",
        "Inspected: 75 % of the view", "no depth after 20 %, edges, and too noisy 5 %", "12 mm × 8.0 mm",
        "Installed work", "as &lt;planned&gt;", "Bob", "Findings of round 1 (the last)", "Inspection closed",
        "false_alarms 0.05", "comparison-1"})
    EXPECT_TRUE(contains(page, part)) << part;
  // The view, and before and after in colour and as depth.
  EXPECT_EQ(count(page, "<img "), 5U);
}

TEST_F(InspectionReport, WhatPeopleTypedIsNoMarkup) {
  const std::string page = report();
  EXPECT_FALSE(contains(page, "<script")) << "a page without any script";
  EXPECT_FALSE(contains(page, "<planned>"));
  EXPECT_FALSE(contains(page, "<camera>"));
  EXPECT_TRUE(contains(page, "N1 &lt;script&gt;"));
  EXPECT_TRUE(contains(page, "bay &amp; 3"));
  EXPECT_FALSE(contains(page, "http:")) << "nothing is loaded from elsewhere";
  EXPECT_FALSE(contains(page, "https:"));
}

TEST_F(InspectionReport, TheSameRecordsGiveTheSameBytes) { EXPECT_EQ(report(), report()); }

TEST_F(InspectionReport, InDarknessDepthIsShown) {
  for (const char* const name : {"initial_color.png", "final_color.png"})
    write_file(result() / name, encode_png(ColorImage(96, 64, {3, 3, 3})));
  EXPECT_EQ(count(report(), "<img "), 3U) << "the view, and before and after as depth";
  for (const char* const name : {"initial_color.png", "final_color.png"}) fs::remove(result() / name);
  EXPECT_EQ(count(report(), "<img "), 3U) << "a camera without colour";
}

TEST_F(InspectionReport, WhatCannotBeReadIsStatedInItsPlace) {
  EXPECT_EQ(count(report(), "Cannot be shown: "), 0U);
  write_file(result() / "final_depth.png", "no picture");
  EXPECT_EQ(count(report(), "Cannot be shown: "), 1U) << "the close-ups";
  EXPECT_TRUE(contains(report(), "1 part of this record cannot be shown"));
  fs::remove(result() / "detections.json");
  EXPECT_EQ(count(report(), "Cannot be shown: "), 2U) << "and the options";
}

TEST_F(InspectionReport, LinksAreNotFollowed) {
  fs::rename(result() / "final_depth.png", data_ / "elsewhere.png");
  fs::create_symlink(data_ / "elsewhere.png", result() / "final_depth.png");
  EXPECT_TRUE(contains(report(), "is a link"));
}

TEST_F(InspectionReport, RecordsThatLeadOutOfTheFolderAreNotFollowed) {
  const std::string elsewhere = (data_ / "elsewhere.png").string();
  write_file(elsewhere, encode_png(ColorImage(96, 64, bright)));
  for (const std::string& picture : {elsewhere, std::string("../../elsewhere.png"), std::string("/")}) {
    history_.inspection.snapshots = {{1, picture, "", "Cy", noon}};
    EXPECT_TRUE(contains(report(), "is not in the folder of its inspection")) << picture;
  }
}

TEST_F(InspectionReport, ANoteIsNoStatementOfTheProgram) {
  history_.inspection.closing = Closing{1, "Ida", "ok.\nInspected: 100 % of the view.", noon};
  const std::string page = report();
  EXPECT_TRUE(contains(
      page, "<blockquote><bdi class=\"typed\">ok.\nInspected: 100 % of the view.</bdi></blockquote>"));
  EXPECT_LT(page.find("Inspected: 75 %"), page.find("Inspected: 100 %"));
}

TEST_F(InspectionReport, DecisionsMadeAlikeAreOneRowAndSupersededOnesRemain) {
  ReviewedFinding second = history_.inspection.findings[0];
  second.number = second.same_as = 2;
  history_.rounds[0].findings.push_back(second);
  const Decision alarm{Verdict::false_alarm, "", "Bob", noon, 1};
  const Decision removed{Verdict::debris_removed, "", "Cy", "2026-01-01T13:00:00.000Z", 1};
  Decision later = alarm;
  later.decided_at = "2026-01-01T14:00:00.000Z";
  history_.decisions = {{1, 1, alarm}, {1, 2, alarm}, {1, 2, removed},
                        {1, 1, alarm}, {1, 2, later}, {0, 1, alarm}};
  const std::string page = report();
  EXPECT_TRUE(contains(page, "Decided, round 1, findings 1 and 2: False alarm"));
  EXPECT_TRUE(contains(page, "Decided, round 1, finding 2: Debris, removed"));
  EXPECT_TRUE(contains(page, "Decided, round 1, finding 2: False alarm")) << "made at another time";
  EXPECT_TRUE(contains(page, "Decided, marked finding 1: False alarm"));
}

TEST_F(InspectionReport, MarkedFindingsAndSnapshotsHaveTheirPictures) {
  fs::create_directories(folder().path() / "marks");
  write_file(folder().path() / "marks" / "001.png", encode_png(ColorImage(96, 64, bright)));
  MarkedFinding marked;
  marked.number = 1;
  marked.picture = "marks/001.png";
  marked.box = {90, 60, 24, 24};
  marked.note = "a <washer>";
  marked.person = "Cy";
  marked.marked_at = noon;
  history_.inspection.marked = {marked};
  history_.inspection.snapshots = {{1, "marks/001.png", "a view", "Cy", noon}};
  const std::string page = report();
  EXPECT_EQ(count(page, "<img "), 7U) << "also where the box reaches beyond the picture";
  EXPECT_TRUE(contains(page, "a &lt;washer&gt;"));
  EXPECT_TRUE(contains(page, "To be decided"));
}

TEST_F(InspectionReport, AnInspectionThatHasOnlyBegunHasAReport) {
  InspectionHistory begun;
  begun.inspection.id = 8;
  begun.inspection.created_at = noon;
  const std::string page = inspection_report(begun, InspectionFolder(data_.path(), 8), made_at);
  EXPECT_TRUE(contains(page, "Not finished: there is no baseline yet"));
  EXPECT_TRUE(contains(page, "Inspection 8"));
  EXPECT_EQ(count(page, "<img "), 0U);
}

TEST_F(InspectionReport, PlannedPartsAreCountedTogether) {
  ComparedRound& round = history_.rounds[0];
  round.compared[0].planned = {{"collars <row 3>", ChangeKind::added, 24, 1, 22, 1}};
  round.findings[0].planned = PlannedState::planned;
  round.findings[0].planned_item = "collars <row 3>";
  const std::string page = report();
  EXPECT_TRUE(contains(page, "1 of 24"));
  EXPECT_TRUE(contains(page, "collars &lt;row 3&gt;"));
  EXPECT_TRUE(contains(page, "1 installed work"));
  EXPECT_EQ(count(page, "<img "), 1U) << "planned parts have no close-ups";
}

}  // namespace
}  // namespace rva
