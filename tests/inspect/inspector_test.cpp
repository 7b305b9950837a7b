#include "inspect/inspector.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "capture/capture.hpp"
#include "core/error.hpp"
#include "depth/image_file.hpp"
#include "sim/simulated_robot.hpp"
#include "store/sqlite_records.hpp"
#include "tests/eventually.hpp"
#include "tests/inspect/waving_camera.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

using test::eventually;
using testing::HasSubstr;

class Standing : public testing::Test {
 protected:
  Standing()
      : plug_(std::make_shared<test::Plug>()), camera_(std::make_unique<test::WavingCamera>(plug_), 1000.0) {
    restart();
  }
  // As after a power cut, but for the camera.
  void restart() {
    inspector_.reset();
    records_ = std::make_unique<SqliteRecords>(folder_ / "rva.db");
    inspector_ = std::make_unique<Inspector>(InspectionRig{camera_}, *records_, folder_.path(),
                                             InspectorOptions{.readiness = {.least_free_gb = 0.0}});
  }
  TaskState wait() {
    EXPECT_TRUE(eventually([&] { return inspector_->task().end != TaskEnd::running; }));
    return inspector_->task();
  }
  TaskState take(std::int64_t id, Side side) {
    inspector_->capture(id, side, "Ann", false);
    return wait();
  }

  // The share of a picture of the first view that is not black.
  double share_drawn(const Inspection& inspection, const std::string& name) {
    const ColorImage picture = read_color(inspector_->folder(inspection.id).result(inspection, 0) / name);
    const auto black = std::ranges::count(picture.pixels(), Rgb{});
    return 1.0 - static_cast<double>(black) / static_cast<double>(picture.size());
  }

  test::TemporaryFolder folder_;
  std::shared_ptr<test::Plug> plug_;
  LiveCamera camera_;
  std::unique_ptr<SqliteRecords> records_;
  std::unique_ptr<Inspector> inspector_;
};

TEST_F(Standing, ALampThatTheCameraLacksIsRefused) {
  InspectorOptions options;
  options.lamp = true;
  EXPECT_THROW(Inspector(InspectionRig{camera_}, *records_, folder_.path(), options), UsageError);
}

TEST_F(Standing, AnInspectionAcrossARestartFindsWhatWasLeft) {
  const std::int64_t id = inspector_->begin({"N1", "bay 3", "WO", "Ann"});
  EXPECT_EQ(take(id, Side::initial).end, TaskEnd::done);
  EXPECT_EQ(stage_of(inspector_->inspection(id)), Stage::work);
  restart();
  plug_->bump_mm = 12;
  const TaskState task = take(id, Side::final);
  EXPECT_EQ(task.end, TaskEnd::done) << task.problem;
  const Inspection inspection = inspector_->inspection(id);
  EXPECT_EQ(stage_of(inspection), Stage::review);
  ASSERT_EQ(inspection.findings.size(), 1U);
  EXPECT_NEAR(*inspection.findings[0].finding.height_mm, 12.0, 1.0);
  for (const char* const picture :
       {"initial_depth.png", "final_depth.png", "changed.png", "not_inspected.png"})
    EXPECT_TRUE(std::filesystem::exists(inspector_->folder(id).result(inspection, 0) / picture)) << picture;
  const std::vector<FindableShare>& findable = inspection.compared.at(0).findable;
  ASSERT_EQ(findable.size(), 3U);
  for (const FindableShare& of : findable)
    EXPECT_DOUBLE_EQ(share_drawn(inspection, fmt::format("findable_{:g}mm.png", of.size_mm)), of.share);
  EXPECT_TRUE(std::filesystem::exists(inspector_->folder(id).map(*inspection.comparison)));
  EXPECT_THROW(inspector_->decide(id, 2, 1, {Verdict::false_alarm, "", "Ann", "t"}), Error)
      << "of findings that are shown no more";
  const int comparison = inspection.comparison->number;
  EXPECT_THROW(inspector_->close(id, comparison, {"", "Ann"}), Error) << "a finding is undecided";
  inspector_->decide(id, comparison, 1, {Verdict::debris_removed, "a bolt", "Ann", "t"});
  EXPECT_EQ(inspector_->inspection(id).findings[0].decision->round, 1);
  EXPECT_THROW(inspector_->close(id, comparison, {"", "Ann"}), Error) << "no picture shows that it is gone";
  plug_->bump_mm = 0;
  take(id, Side::final);
  EXPECT_EQ(stage_of(inspector_->inspection(id)), Stage::review) << "nobody has looked yet";
  EXPECT_THROW(inspector_->close(id, comparison, {"", "Ann"}), Error) << "another comparison was reviewed";
  EXPECT_THROW(inspector_->close(id, comparison + 1, {"", " "}), Error) << "nobody";
  inspector_->close(id, comparison + 1, {"", "Ann"});
  EXPECT_EQ(stage_of(inspector_->inspection(id)), Stage::done);
}

TEST_F(Standing, EveryRoundStaysWithWhatItShowed) {
  const std::int64_t id = inspector_->begin({"", "", "", "Ann"});
  take(id, Side::initial);
  plug_->bump_mm = 12;
  take(id, Side::final);
  inspector_->decide(id, 1, 1, {Verdict::debris_removed, "a bolt", "Ann", "t"});
  plug_->bump_mm = 0;
  take(id, Side::final);
  restart();
  const std::vector<ComparedRound> rounds = inspector_->rounds(id);
  ASSERT_EQ(rounds.size(), 2U);
  EXPECT_TRUE(rounds[0].findings.empty());
  EXPECT_EQ(rounds[0].final->round, 2);
  ASSERT_EQ(rounds[1].findings.size(), 1U);
  EXPECT_EQ(rounds[1].findings[0].decision->note, "a bolt");
  EXPECT_EQ(rounds[1].final->round, 1);
  EXPECT_GT(rounds[1].compared.at(0).judged, 0.5);
}

TEST_F(Standing, WhatAPersonMarksIsAFindingThroughAllRounds) {
  const std::int64_t id = inspector_->begin({"", "", "", "Ann"});
  take(id, Side::initial);
  EXPECT_THROW(inspector_->mark(id, 1, 0, {5, 5, 9, 9}, {"", "Ann"}), Error) << "there are no pictures yet";
  EXPECT_EQ(inspector_->mark_in_picture(id, {.box = {0, 0, 4, 4}}, ColorImage(4, 4), {"a rag", "Ann"}), 1);
  take(id, Side::final);
  EXPECT_THROW(inspector_->mark(id, 1, 1, {5, 5, 9, 9}, {"", "Ann"}), Error) << "no such view";
  EXPECT_THROW(inspector_->mark(id, 2, 0, {5, 5, 9, 9}, {"", "Ann"}), Error) << "not these pictures";
  EXPECT_THROW(inspector_->mark(id, 1, 0, {5, 5, 9, 9}, {"", ""}), Error) << "nobody";
  EXPECT_EQ(inspector_->mark(id, 1, 0, {5, 5, 9, 9}, {"a washer", "Bob"}), 2);
  inspector_->decide_mark(id, 1, {Verdict::debris_removed, "", "Ann", "t"});
  take(id, Side::final);
  const Inspection inspection = inspector_->inspection(id);
  ASSERT_EQ(inspection.marked.size(), 2U);
  EXPECT_EQ(inspection.marked[0].round, 0);
  EXPECT_EQ(inspection.marked[1].note, "a washer");
  EXPECT_EQ(inspection.marked[1].person, "Bob");
  EXPECT_TRUE(inspection.marked[1].position_m);
  for (const MarkedFinding& marked : inspection.marked)
    EXPECT_TRUE(std::filesystem::exists(inspector_->folder(id).path() / marked.picture)) << marked.picture;
  EXPECT_THROW(inspector_->close(id, 2, {"", "Ann"}), Error) << "one is undecided";
  EXPECT_THROW(inspector_->decide_all(id, 2, {}), Error) << "nothing";
  EXPECT_THROW(inspector_->decide_all(id, 2, {{2, true, {Verdict::debris, "", "", "t"}}}), Error) << "nobody";
  inspector_->decide_all(id, 2, {{2, true, {Verdict::false_alarm, "", "Ann", "t"}}});
  EXPECT_EQ(inspector_->inspection(id).marked[1].decision->round, 2);
  EXPECT_NO_THROW(inspector_->close(id, 2, {"", "Ann"})) << "the other one was removed before the last round";
  EXPECT_THROW(inspector_->decide_mark(id, 2, {Verdict::debris, "", "Ann", "t"}), Error) << "closed";
  EXPECT_THROW(inspector_->mark(id, 2, 0, {5, 5, 9, 9}, {"", "Ann"}), Error) << "closed";
  EXPECT_THROW(inspector_->capture(id, Side::final, "Ann", false), Error) << "closed";
  EXPECT_THROW(inspector_->compare(id), Error) << "closed";
  EXPECT_THROW(inspector_->set_ignored(id, 0, {}), Error) << "closed";
}

TEST_F(Standing, AnInspectionIsRemovedOnlyWhileNothingWasCapturedOrMarked) {
  const std::int64_t empty = inspector_->begin({"", "", "", "Ann"});
  const std::int64_t marked = inspector_->begin({"", "", "", "Ann"});
  const std::int64_t taken = inspector_->begin({"", "", "", "Ann"});
  static_cast<void>(
      inspector_->mark_in_picture(marked, {.box = {0, 0, 4, 4}}, ColorImage(4, 4), {"", "Ann"}));
  take(taken, Side::initial);
  inspector_->remove(empty);
  EXPECT_FALSE(inspector_->has(empty));
  EXPECT_THROW(inspector_->remove(empty), Error);
  EXPECT_THROW(inspector_->remove(marked), Error);
  EXPECT_THROW(inspector_->remove(taken), Error);
  EXPECT_TRUE(inspector_->has(marked) && inspector_->has(taken));
}

TEST_F(Standing, WhatIsLeftOutIsNotFoundAndTheComparisonIsMadeAgain) {
  const std::int64_t id = inspector_->begin({"", "", "", "Ann"});
  const Polygon everything{{-1, -1}, {2000, -1}, {2000, 2000}, {-1, 2000}};
  EXPECT_THROW(inspector_->set_ignored(id, 0, {everything}), Error) << "there is no picture to draw on";
  take(id, Side::initial);
  EXPECT_THROW(inspector_->set_ignored(id, 1, {everything}), Error) << "no such view";
  plug_->bump_mm = 12;
  take(id, Side::final);
  ASSERT_EQ(inspector_->inspection(id).findings.size(), 1U);
  inspector_->set_ignored(id, 0, {everything});
  EXPECT_EQ(stage_of(inspector_->inspection(id)), Stage::work) << "it was compared without them";
  inspector_->compare(id);
  EXPECT_EQ(wait().end, TaskEnd::done);
  const Inspection inspection = inspector_->inspection(id);
  EXPECT_TRUE(inspection.findings.empty());
  EXPECT_EQ(inspection.compared.at(0).coverage.left_out, 1.0);
  inspector_->set_ignored(id, 0, {});
  inspector_->compare(id);
  wait();
  EXPECT_EQ(inspector_->inspection(id).findings.size(), 1U);
}

TEST_F(Standing, FindingsAreComparedWithThePlanOfTheirView) {
  const std::int64_t id = inspector_->begin({"", "", "", "Ann"});
  const auto square = [](double u, double v) {
    return std::vector<PlanPoint>{
        {{u - 20, v - 20}}, {{u + 20, v - 20}}, {{u + 20, v + 20}}, {{u - 20, v + 20}}};
  };
  PlannedItem box;
  box.name = "box";
  box.height_mm = {10, 15};
  box.areas = {square(80, 60)};
  PlannedItem bracket;
  bracket.name = "bracket";
  bracket.height_mm = {20, 25};
  bracket.places = {{{130, 90}}};
  const Plan plan{PlanCoordinates::pixels, {box, bracket}};
  EXPECT_THROW(inspector_->set_plan(id, 0, &plan), Error) << "there is no picture to draw on";
  take(id, Side::initial);
  EXPECT_THROW(inspector_->set_plan(id, 1, &plan), Error) << "no such view";
  plug_->bump_mm = 12;
  take(id, Side::final);
  EXPECT_FALSE(inspector_->inspection(id).findings.at(0).planned);
  inspector_->set_plan(id, 0, &plan);
  EXPECT_EQ(stage_of(inspector_->inspection(id)), Stage::work) << "it was compared without the plan";
  inspector_->compare(id);
  EXPECT_EQ(wait().end, TaskEnd::done) << wait().problem;
  Inspection inspection = inspector_->inspection(id);
  ASSERT_EQ(inspection.findings.size(), 2U);
  const ReviewedFinding& missing = inspection.findings[0];
  EXPECT_EQ(missing.planned, PlannedState::missing);
  EXPECT_EQ(missing.planned_item, "bracket");
  EXPECT_TRUE(missing.finding.box.x <= 130 && missing.finding.box.x + missing.finding.box.width > 130);
  EXPECT_NEAR(missing.finding.position_m->z(), 0.8, 0.005) << "of the surface where it should be";
  EXPECT_EQ(inspection.findings[1].planned, PlannedState::planned);
  EXPECT_EQ(inspection.findings[1].planned_item, "box");
  EXPECT_EQ(inspection.compared.at(0).planned,
            (std::vector<PlannedWork>{{"box", ChangeKind::added, 1, 1, 0, 0},
                                      {"bracket", ChangeKind::added, 1, 0, 1, 0}}));
  EXPECT_TRUE(std::filesystem::exists(inspector_->folder(id).result(inspection, 0) / "plan.json"));
  EXPECT_EQ(undecided(inspection), 2U) << "a missing part is decided on, as a finding is";
  inspector_->decide(id, inspection.comparison->number, 1, {Verdict::installed_work, "", "Ann", ""});
  EXPECT_EQ(undecided(inspector_->inspection(id)), 1U);

  inspector_->set_plan(id, 0, nullptr);
  inspector_->compare(id);
  wait();
  inspection = inspector_->inspection(id);
  EXPECT_EQ(inspection.findings.size(), 1U);
  EXPECT_TRUE(inspection.compared.at(0).planned.empty());
}

TEST_F(Standing, WhereNothingChangedNothingIsFound) {
  const std::int64_t id = inspector_->begin({"", "", "", "Ann"});
  take(id, Side::initial);
  EXPECT_EQ(take(id, Side::final).end, TaskEnd::done);
  EXPECT_TRUE(inspector_->inspection(id).findings.empty());
}

TEST_F(Standing, AFinalCaptureThatWasNotComparedIsNotDone) {
  const std::int64_t id = inspector_->begin({"", "", "", "Ann"});
  take(id, Side::initial);
  take(id, Side::final);
  EXPECT_EQ(stage_of(inspector_->inspection(id)), Stage::review);
  // Somebody does more work, and ends the second look before it is compared.
  plug_->bump_mm = 12;
  inspector_->capture(id, Side::final, "Ann", false);
  ASSERT_TRUE(eventually([&] { return inspector_->task().kind != TaskKind::capture; }));
  inspector_->cancel();
  if (wait().end == TaskEnd::cancelled) {
    EXPECT_EQ(stage_of(inspector_->inspection(id)), Stage::work);
    inspector_->compare(id);
    EXPECT_EQ(wait().end, TaskEnd::done);
  }
  EXPECT_EQ(inspector_->inspection(id).findings.size(), 1U);
}

// A finding was removed, and the bay is looked at again.
TEST_F(Standing, AFinalSideThatIsTakenAgainLeavesTheEarlierOneWhereItIs) {
  const std::int64_t id = inspector_->begin({"", "", "", "Ann"});
  take(id, Side::initial);
  plug_->bump_mm = 12;
  take(id, Side::final);
  const Inspection before = inspector_->inspection(id);
  ASSERT_EQ(before.findings.size(), 1U);
  const std::filesystem::path earlier = inspector_->folder(id).capture(Side::final, before, 0, 0);
  const auto taken_at = std::filesystem::last_write_time(earlier / "capture.json");
  plug_->bump_mm = 0;
  EXPECT_EQ(take(id, Side::final).end, TaskEnd::done);
  const Inspection after = inspector_->inspection(id);
  EXPECT_TRUE(after.findings.empty());
  EXPECT_EQ(after.final->round, 2);
  EXPECT_NE(inspector_->folder(id).capture(Side::final, after, 0, 0), earlier);
  EXPECT_EQ(std::filesystem::last_write_time(earlier / "capture.json"), taken_at);
  EXPECT_TRUE(std::filesystem::exists(inspector_->folder(id).result(before, 0) / "changed.png"))
      << "what a person has decided on can be looked at again";
}

// Somebody may have worked in the bay since.
TEST_F(Standing, AFinalSideThatWasEndedIsTakenAsAWholeAndTheEarlierOneHoldsUntilThen) {
  const std::int64_t id = inspector_->begin({"", "", "", "Ann"});
  take(id, Side::initial);
  plug_->bump_mm = 12;
  take(id, Side::final);
  inspector_->capture(id, Side::final, "Ann", false);
  inspector_->cancel();
  ASSERT_EQ(wait().end, TaskEnd::cancelled);
  restart();
  EXPECT_EQ(inspector_->inspection(id).final->round, 1);
  inspector_->compare(id);
  EXPECT_EQ(wait().end, TaskEnd::done) << "with the earlier one";
  EXPECT_EQ(take(id, Side::final).end, TaskEnd::done);
  EXPECT_EQ(inspector_->inspection(id).final->round, 3);
}

// Killed after the last view was complete, before it was recorded.
TEST_F(Standing, AFinalSideThatWasNotRecordedIsNotTakenForTheBayOfNow) {
  const std::int64_t id = inspector_->begin({"", "", "", "Ann"});
  take(id, Side::initial);
  take(id, Side::final);
  const Inspection first = inspector_->inspection(id);
  records_->begin_side(id, Side::final, {2, "Ann", first.final->base});
  std::filesystem::copy(inspector_->folder(id).side(Side::final, 1),
                        inspector_->folder(id).side(Side::final, 2),
                        std::filesystem::copy_options::recursive);
  restart();
  plug_->bump_mm = 12;
  EXPECT_EQ(take(id, Side::final).end, TaskEnd::done);
  EXPECT_EQ(inspector_->inspection(id).findings.size(), 1U);
  EXPECT_EQ(inspector_->inspection(id).final->round, 3);
}

TEST_F(Standing, AStartThatWasAskedForBeforeAStopDoesNotHappen) {
  const std::int64_t id = inspector_->begin({"", "", "", "Ann"});
  TaskRunner tasks;
  const std::uint64_t before = tasks.ends_asked_for();
  tasks.stop_capture();
  EXPECT_THROW(tasks.start({.kind = TaskKind::capture}, before, [] { return [] {}; }), Error);
  tasks.cancel();
  EXPECT_NO_THROW(tasks.start({.kind = TaskKind::capture}, tasks.ends_asked_for(), [] { return [] {}; }));
  EXPECT_EQ(take(id, Side::initial).end, TaskEnd::done);
}

// What a task reads is settled when it starts, also while a check of readiness has to end first.
TEST_F(Standing, ViewsAndRegionsDoNotChangeUnderATask) {
  const std::int64_t id = inspector_->begin({"", "", "", "Ann"});
  inspector_->check_readiness();
  inspector_->capture(id, Side::initial, "Ann", false);
  EXPECT_THROW(inspector_->set_views(id, {{1, 1}}), Error)
      << "it is recorded as begun when the request returns";
  wait();
}

TEST_F(Standing, NothingIsWrittenThroughALink) {
  const std::int64_t id = inspector_->begin({"", "", "", "Ann"});
  std::filesystem::create_directory(folder_ / "elsewhere");
  std::filesystem::create_directories(inspector_->folder(id).path());
  std::filesystem::create_directory_symlink(folder_ / "elsewhere",
                                            inspector_->folder(id).side(Side::initial, 1));
  static_cast<void>(take(id, Side::initial));
  EXPECT_TRUE(std::filesystem::is_empty(folder_ / "elsewhere"));
  std::filesystem::remove_all(folder_ / "inspections");
  std::filesystem::create_directory_symlink(folder_ / "elsewhere", folder_ / "inspections");
  EXPECT_THROW(inspector_->capture(id, Side::initial, "Ann", false), Error);
}

TEST_F(Standing, TheBaselineIsTakenOnceAndNeedsToBeThere) {
  const std::int64_t id = inspector_->begin({"", "", "", "Ann"});
  take(id, Side::initial);
  EXPECT_THROW(inspector_->capture(id, Side::initial, "Ann", false), Error);
  std::filesystem::remove_all(inspector_->folder(id).path());
  EXPECT_THROW(inspector_->capture(id, Side::final, "Ann", false), Error) << "not after the work";
}

TEST_F(Standing, StopEndsACaptureAndNothingElse) {
  const std::int64_t id = inspector_->begin({"", "", "", "Ann"});
  inspector_->capture(id, Side::initial, "Ann", false);
  inspector_->stop_capture();
  EXPECT_EQ(wait().end, TaskEnd::cancelled);
  inspector_->check_readiness();
  inspector_->stop_capture();
  EXPECT_EQ(wait().end, TaskEnd::done);
}

TEST_F(Standing, OneTaskAtATimeWhichCanBeCancelledAndGoneOnWith) {
  const std::int64_t id = inspector_->begin({"", "", "", "Ann"});
  inspector_->capture(id, Side::initial, "Ann", false);
  EXPECT_THROW(inspector_->check_readiness(), Error);
  inspector_->cancel();
  EXPECT_EQ(wait().end, TaskEnd::cancelled);
  EXPECT_FALSE(inspector_->inspection(id).initial);
  EXPECT_EQ(take(id, Side::initial).end, TaskEnd::done);
}

TEST_F(Standing, StepsOutOfOrderAreRefused) {
  const std::int64_t id = inspector_->begin({"", "", "", "Ann"});
  EXPECT_THROW(inspector_->capture(id, Side::final, "Ann", false), Error) << "no baseline";
  EXPECT_THROW(inspector_->compare(id), Error);
  EXPECT_THROW(inspector_->decide(id, 1, 1, {Verdict::false_alarm, "", "Ann", "t"}), Error);
  EXPECT_THROW(inspector_->set_views(id, {{0, 0}, {5, 5}}), Error) << "it stands still";
  EXPECT_THROW(inspector_->capture(id + 1, Side::initial, "Ann", false), Error) << "no such inspection";
  EXPECT_THROW(static_cast<void>(inspector_->begin({"", "", "", "  "})), Error) << "nobody";
  take(id, Side::initial);
  EXPECT_THROW(inspector_->set_views(id, {{1, 1}}), Error) << "the baseline has its view";
}

TEST_F(Standing, ReadinessNamesWhatIsMissing) {
  inspector_->check_readiness();
  wait();
  ASSERT_TRUE(inspector_->readiness());
  EXPECT_TRUE(inspector_->readiness()->ready());
  plug_->pulled = true;
  ASSERT_TRUE(eventually([&] { return !camera_.health().problem.empty(); }));
  inspector_->check_readiness();
  wait();
  EXPECT_FALSE(inspector_->readiness()->ready());
  EXPECT_THAT(inspector_->readiness()->items.at(0).says, HasSubstr("unplugged"));
}

TEST(WithRobot, AnInspectionBeginsWithTheViewInWhichTheRobotRests) {
  const test::TemporaryFolder folder;
  LiveCamera camera(std::make_unique<test::WavingCamera>(std::make_shared<test::Plug>()), 1000.0);
  SimulatedRobot robot({.speed_deg_s = 20.0});
  Drive drive(robot);
  SqliteRecords records(folder / "rva.db");
  Inspector inspector({camera, &drive}, records, folder.path());
  ASSERT_TRUE(eventually([&] { return drive.state().joints.has_value(); }));
  robot.move_to({-20, 0});
  EXPECT_NEAR(inspector.inspection(inspector.begin({"", "", "", "Ann"})).views.at(0).pan_deg, -20.0, 0.4);
  robot.move_to({70, 0});
  EXPECT_THROW(static_cast<void>(inspector.begin({"", "", "", "Ann"})), Error) << "it moves for 4.5 seconds";
}

TEST(WithRobot, AFinalSideForWhichAnotherThingIsSaidIsBegunAnew) {
  const test::TemporaryFolder folder;
  LiveCamera camera(std::make_unique<test::WavingCamera>(std::make_shared<test::Plug>()), 1000.0);
  SimulatedRobot robot({.speed_deg_s = 1000.0});
  Drive drive(robot);
  SqliteRecords records(folder / "rva.db");
  Inspector inspector({camera, &drive}, records, folder.path(),
                      {.frames = 8, .dither = 1, .readiness = {.least_free_gb = 0.0}});
  const auto capture = [&](Side side, bool replaced, std::size_t views) {
    inspector.capture(1, side, "Ann", replaced);
    EXPECT_TRUE(eventually([&] {
      if (inspector.task().end != TaskEnd::running) return true;
      if (inspector.task().progress.view >= views) inspector.cancel();
      return false;
    }));
  };
  ASSERT_TRUE(eventually([&] { return drive.state().joints.has_value(); }));
  ASSERT_EQ(inspector.begin({"", "", "", "Ann"}), 1);
  inspector.set_views(1, {{0, 0}, {5, 0}, {10, 0}});
  EXPECT_THROW(inspector.capture(1, Side::initial, "Ann", true), Error) << "put back since when?";
  capture(Side::initial, false, 3);
  EXPECT_FALSE(inspector.replaced_before_final(inspector.inspection(1)));
  capture(Side::final, true, 2);
  EXPECT_EQ(inspector.task().end, TaskEnd::cancelled);
  EXPECT_EQ(inspector.replaced_before_final(inspector.inspection(1)), std::optional(true));
  capture(Side::final, false, 3);  // a flat wall, whose views cannot be registered afterwards
  const Inspection inspection = inspector.inspection(1);
  ASSERT_TRUE(inspection.final);
  EXPECT_FALSE(inspector.replaced_before_final(inspection)) << "it is under way no more";
  EXPECT_EQ(inspection.final->round, 2) << "what was captured from another base stays as it was";
  EXPECT_TRUE(std::filesystem::exists(inspector.folder(1).side(Side::final, 1) / "000" / "capture.json"));
  for (int view = 0; view < 3; ++view) {
    const auto taken = open_capture(inspector.folder(1).capture(Side::final, inspection, view, 0));
    EXPECT_EQ(taken->info().pose->base, inspection.initial->base) << view;
  }
}

}  // namespace
}  // namespace rva
