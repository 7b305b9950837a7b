#include "server/json_of.hpp"

#include <gtest/gtest.h>

#include <memory>

namespace rva {
namespace {

ReviewedFinding bare_finding() {
  ReviewedFinding reviewed;
  reviewed.number = 3;
  reviewed.view = 1;
  reviewed.same_as = 2;
  reviewed.finding.kind = ChangeKind::removed;
  reviewed.finding.box = {4, 5, 6, 7};
  reviewed.finding.centroid = {6.5, 8.25};
  return reviewed;
}

TEST(JsonOf, FindingStatesWhatIsKnown) {
  ReviewedFinding reviewed = bare_finding();
  EXPECT_EQ(json_of(reviewed), Json::parse(R"({"number": 3, "view": 1, "same_as": 2, "kind": "removed",
      "bbox": [4, 5, 6, 7], "centroid": [6.5, 8.25], "evidence": ["depth"]})"));
  Finding& finding = reviewed.finding;
  finding.position_m = Eigen::Vector3d(0.5, -0.25, 1.0);
  finding.size_mm = {12.0, 8.0};
  finding.height_mm = -4.0;
  finding.above_surroundings_mm = 3.5;
  finding.background_jump = true;
  finding.top_above_surroundings_mm = 6.5;
  finding.top_is_least = true;
  finding.score = 2.5;
  finding.p_value = 0.001;
  finding.evidence = {.depth = false, .appearance = true};
  reviewed.in_foot_m = Eigen::Vector3d(1.0, 2.0, 3.0);
  reviewed.clear_px = 40;
  reviewed.moved_from = 1;
  reviewed.likely_class = "sheet holder";
  reviewed.class_probability = 0.75;
  reviewed.decision =
      Decision{Verdict::installed_work, "a clip", "Ann", "2026-01-01T00:00:00.000Z", 2, "clip"};
  EXPECT_EQ(json_of(reviewed), Json::parse(R"({"number": 3, "view": 1, "same_as": 2, "kind": "removed",
      "bbox": [4, 5, 6, 7], "centroid": [6.5, 8.25], "position_m": [0.5, -0.25, 1.0],
      "in_foot_m": [1.0, 2.0, 3.0], "size_mm": [12.0, 8.0], "height_mm": -4.0, "above_surroundings_mm": 3.5,
      "background_jump": true, "top_above_surroundings_mm": 6.5, "top_is_least": true, "clear_px": 40,
      "score": 2.5, "p_value": 0.001,
      "evidence": ["appearance"], "moved_from": 1, "class": "sheet holder", "probability": 0.75, "decision": {"verdict": "installed-work",
      "note": "a clip", "person": "Ann", "decided_at": "2026-01-01T00:00:00.000Z",
      "round": 2, "object": "clip"}})"));
}

TEST(JsonOf, InspectionStatesItsSidesAndViews) {
  Inspection inspection;
  inspection.id = 7;
  inspection.order = {"N1", "bay 3", "WO 5", "Ann"};
  inspection.created_at = "t0";
  inspection.views = {{10.0, -5.0}, {20.0, -5.0}};
  const Json begun = json_of(inspection);
  EXPECT_EQ(begun["stage"], "baseline");
  for (const char* const key : {"initial", "final", "comparison", "compared_at"})
    EXPECT_FALSE(begun.contains(key)) << key;
  EXPECT_EQ(begun["views"].dump(), R"([{"pan_deg":10.0,"tilt_deg":-5.0},{"pan_deg":20.0,"tilt_deg":-5.0}])");
  inspection.initial = TakenSide{"t1", "Ann", "b1", 1};
  inspection.final = TakenSide{"t2", "Bob", "b1", 4};
  inspection.comparison = RecordedComparison{2, "t3", "comparison-2"};
  inspection.ignored[1] = {{{0.0, 0.0}, {5.5, 0.0}, {0.0, 5.0}}};
  inspection.ignored[0] = {};
  const Json json = json_of(inspection);
  EXPECT_EQ(json["final"], Json::parse(R"({"taken_at": "t2", "person": "Bob", "base": "b1", "round": 4})"));
  EXPECT_EQ(json["comparison"], 2);
  EXPECT_EQ(json["compared_at"], "t3");
  EXPECT_FALSE(json["views"][0].contains("ignore"));
  EXPECT_EQ(json["views"][1]["ignore"].dump(), "[[[0.0,0.0],[5.5,0.0],[0.0,5.0]]]");
}

TEST(JsonOf, ComparedViewStatesItsCoverage) {
  Inspection inspection;
  ComparedView view{1,
                    "calibrated",
                    {0.5, 0.25, 0.25, {}, {}},
                    0.75,
                    {"/data/inspections/000001/x: is dark"},
                    {{5.0, 0.25}}};
  inspection.compared = {view};
  EXPECT_EQ(json_of(inspection)["compared"][0], Json::parse(R"({"view": 1, "method": "calibrated",
      "coverage": {"compared": 0.5, "unseen": 0.25, "invalid": 0.25}, "judged": 0.75,
      "warnings": ["inspections/000001/x: is dark"], "findable": [{"size_mm": 5.0, "share": 0.25}]})"));
  inspection.compared[0].coverage.left_out = 0.125;
  EXPECT_EQ(json_of(inspection)["compared"][0]["coverage"]["left_out"], 0.125);
}

TEST(JsonOf, SummaryHasCountsInPlaceOfFindings) {
  InspectionSummary summary;
  summary.id = 9;
  summary.stage = Stage::review;
  summary.findings = 4;
  summary.undecided = 3;
  const Json json = json_of(summary);
  EXPECT_EQ(json["findings_count"], 4);
  EXPECT_EQ(json["undecided_count"], 3);
  EXPECT_EQ(json["stage"], "review");
  EXPECT_FALSE(json.contains("findings"));
}

TEST(JsonOf, ReadinessIsThatOfAllItems) {
  Readiness readiness{{{"Camera", true, "fine.", "camera-ready", {{"rate_hz", 30.0}}},
                       {"Disk", false, "/home/ann/data is full.", "disk-unknown"}},
                      "t"};
  EXPECT_EQ(json_of(readiness), Json::parse(R"({"ready": false, "checked_at": "t", "items": [
      {"name": "Camera", "ready": true, "says": "fine.", "code": "camera-ready", "values": {"rate_hz": 30.0}},
      {"name": "Disk", "ready": false, "says": "…/data is full.", "code": "disk-unknown", "values": {}}]})"));
  readiness.items[1].ready = true;
  EXPECT_EQ(json_of(readiness)["ready"], true);
}

TEST(JsonOf, TaskStatesWhatItWaitsForWithoutPaths) {
  TaskState task;
  const Json idle = json_of(task);
  EXPECT_EQ(idle["end"], "done");
  for (const char* const key : {"inspection", "waiting", "problem", "noise"})
    EXPECT_FALSE(idle.contains(key)) << key;
  task.number = 5;
  task.kind = TaskKind::capture;
  task.end = TaskEnd::failed;
  task.inspection = 2;
  task.side = Side::final;
  task.progress = {1, 3, 0, 2, 7, 30, 1, 4};
  task.problem = "/srv/rva/inspections/000002/final/001: disk full";
  task.waiting = "/dev/ttyUSB0: robot";
  const Json json = json_of(task);
  EXPECT_EQ(json["kind"], "capture");
  EXPECT_EQ(json["side"], "final");
  EXPECT_EQ(json["problem"], "inspections/000002/final/001: disk full");
  EXPECT_EQ(json["waiting"], "/dev/ttyUSB0: robot");
  EXPECT_EQ(json["view"], 1);
  EXPECT_EQ(json["views"], 3);
  EXPECT_EQ(json["capture"], 0);
  EXPECT_EQ(json["captures"], 2);
  EXPECT_EQ(json["frame"], 7);
  EXPECT_EQ(json["frames"], 30);
  EXPECT_EQ(json["approach"], 1);
  EXPECT_EQ(json["approaches"], 4);
}

TEST(JsonOf, NoiseIsRounded) {
  TaskState task;
  auto noise = std::make_shared<NoiseSoFar>();
  noise->frames = 12;
  noise->measured = 0.875;
  noise->median_std_mm = 0.12678;
  noise->findable = {0.5, 9, 0.01, 0.02, {}, {{0.39999999, 0.6000001, 50, 2.3456, 4.99}}, {{5.0, 0.123456}}};
  task.noise = noise;
  EXPECT_EQ(json_of(task)["noise"].dump(),
            R"({"frames":12,"measured":0.875,"median_std_mm":0.13,"findable":{"judged":0.5,"window_px":9,)"
            R"("by_distance":[{"from_m":0.4,"to_m":0.6,"median_mm":2.3,"p90_mm":5.0}],)"
            R"("findable":[{"size_mm":5.0,"share":0.1235}]}})");
}

TEST(JsonOf, RobotStatesItsAnglesWhileTheyAreKnown) {
  DriveState state;
  state.joints = PanTilt{12.3456, -0.004};
  state.lent = true;
  const RobotLimits limits{{-90.0, 90.0}, {-60.0, 9.0}};
  EXPECT_EQ(
      json_of(state, limits),
      Json::parse(R"({"driving": false, "armed": true, "lent": true, "at_limit": false, "pan_deg": 12.35,
            "tilt_deg": -0.0, "limits": {"pan_deg": [-90.0, 90.0], "tilt_deg": [-60.0, 9.0]}})"));
  state.joints.reset();
  state.problem = "robot: is disconnected";
  const Json unknown = json_of(state, limits);
  EXPECT_FALSE(unknown.contains("pan_deg"));
  EXPECT_EQ(unknown["problem"], "robot: is disconnected");
}

}  // namespace
}  // namespace rva
