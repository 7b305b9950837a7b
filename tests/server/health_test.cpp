#include "server/health.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "core/json_object.hpp"
#include "server/api.hpp"
#include "server/state_events.hpp"
#include "tests/eventually.hpp"
#include "tests/server/served.hpp"

namespace rva {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

std::string problem_of(const std::vector<HealthCheck>& checks, const std::string& name) {
  const auto found = std::ranges::find(checks, name, &HealthCheck::name);
  return found == checks.end() ? "no such check" : found->problem;
}

std::vector<std::string> names(const std::vector<Event>& events) {
  std::vector<std::string> names;
  for (const Event& event : events) names.push_back(event.name);
  return names;
}

TEST(Health, IsStatedWithoutSigningInAndWithoutFolders) {
  test::Served served;
  const ApiResponse answer = Api(served.parts(), false).answer({"GET", "/api/health", "", "", "", "", ""});
  EXPECT_EQ(answer.status, 200) << answer.body;
  const Json json = Json::parse(answer.body);
  EXPECT_EQ(json["healthy"], true);
  EXPECT_EQ(json["checks"].size(), 5U);
  EXPECT_THAT(answer.body, testing::Not(HasSubstr(served.folder.path().string())));
}

TEST(Health, NamesACameraThatIsUnplugged) {
  test::Served served;
  served.plug->pulled = true;
  EXPECT_TRUE(test::eventually([&] { return !problem_of(check_health(served.parts()), "camera").empty(); }));
  EXPECT_FALSE(is_healthy(check_health(served.parts())));
  EXPECT_EQ(Api(served.parts(), false).answer({"GET", "/api/health", "", "", "", "", ""}).status, 503);
}

TEST(Health, NamesACameraThatIsSilent) {
  EXPECT_EQ(camera_problem({.frames = 5, .lost = 0, .rate_hz = 30.0, .silence_s = 9.0, .problem = ""}), "");
  EXPECT_EQ(camera_problem({.frames = 5, .lost = 0, .rate_hz = 30.0, .silence_s = 12.0, .problem = ""}),
            "camera: has given no frame for 12 seconds; check its cable, or connect it again");
  EXPECT_EQ(camera_problem({.frames = 0, .lost = 0, .rate_hz = 0.0, .silence_s = 0.0, .problem = "is gone"}),
            "is gone");
}

TEST(Health, NamesADataFolderThatIsGone) {
  test::Served served;
  const ServerParts parts = served.parts();
  std::filesystem::remove_all(served.folder.path());
  EXPECT_THAT(problem_of(check_health(parts), "data"), HasSubstr("no file can be written here"));
}

TEST(Health, IsWrittenToTheDiskAtMostOnceInTenSeconds) {
  const test::TemporaryFolder folder;
  DataFolderProbe probe;
  EXPECT_EQ(probe.problem(folder.path(), 100.0), "");
  EXPECT_EQ(probe.problem(folder / "missing", 109.0), "") << "still the answer from before";
  EXPECT_NE(probe.problem(folder / "missing", 111.0), "");
}

TEST(StateEvents, AreTheChangesOfHealth) {
  StateEvents events;
  EXPECT_THAT(events.of_health({{"camera", ""}, {"disk", ""}}, 0.0), IsEmpty());
  EXPECT_THAT(names(events.of_health({{"camera", "is silent"}, {"disk", ""}}, 1.0)),
              ElementsAre("camera-failed"));
  EXPECT_THAT(events.of_health({{"camera", "is still silent"}, {"disk", ""}}, 2.0), IsEmpty());
  const std::vector<Event> back = events.of_health({{"camera", ""}, {"disk", "is full"}}, 4.5);
  EXPECT_THAT(names(back), ElementsAre("camera-back", "disk-failed"));
  EXPECT_THAT(back[0].fields, ElementsAre(testing::Pair("failed_s", "3.5")));
  EXPECT_EQ(back[1].level, EventLevel::warning);
}

TEST(StateEvents, AreStartAndEndOfEachTask) {
  StateEvents events;
  TaskState task;
  EXPECT_THAT(events.of_task(task, 0.0), IsEmpty()) << "no task yet";
  task = {.number = 1, .kind = TaskKind::capture, .end = TaskEnd::running, .inspection = 7};
  EXPECT_THAT(names(events.of_task(task, 1.0)), ElementsAre("task-started"));
  EXPECT_THAT(events.of_task(task, 2.0), IsEmpty());
  task.end = TaskEnd::failed;
  task.problem = "the disk is full";
  const std::vector<Event> ended = events.of_task(task, 3.0);
  ASSERT_THAT(names(ended), ElementsAre("task-ended"));
  EXPECT_EQ(event_text(ended[0]),
            "capture: failed: the disk is full event=task-ended kind=capture task=1 inspection=7 end=failed "
            "duration_s=2.0");
  EXPECT_EQ(ended[0].level, EventLevel::warning);
  EXPECT_THAT(events.of_task(task, 4.0), IsEmpty());
  task = {.number = 2, .kind = TaskKind::readiness, .end = TaskEnd::done};
  EXPECT_THAT(names(events.of_task(task, 5.0)), ElementsAre("task-started", "task-ended"))
      << "a task that was shorter than the time between two states";
}

}  // namespace
}  // namespace rva
