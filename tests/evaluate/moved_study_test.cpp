#include "evaluate/moved_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/json_object.hpp"
#include "evaluate/moved_evaluation_json.hpp"
#include "evaluate/moved_report.hpp"
#include "evaluate/moved_tally.hpp"
#include "evaluate/moved_wing.hpp"
#include "scene/camera_stand.hpp"

namespace rva {
namespace {

TEST(MovedWing, RobotsStandApartInOneBayAndOnlyTheLaterOneSeesDebris) {
  for (std::uint64_t seed = 1; seed < 40; ++seed) {
    const MovedWing wing = random_moved_wing(seed, CameraReturn::elsewhere);
    const Transform move =
        world_from_camera(wing.before.stand).inverse() * world_from_camera(wing.after.stand);
    EXPECT_GT(move.translation().norm(), 0.1);
    EXPECT_LT(move.translation().norm(), 0.45);
    EXPECT_NE(wing.before.stand.base, wing.after.stand.base);
    for (const CameraStand& stand : {wing.before.stand, wing.after.stand})
      EXPECT_LT(std::abs(stand.position_m.x()), wing.after.bay.max().x() - 0.17);
    const auto debris = [](const Scene& scene) {
      return std::ranges::count(scene.objects, Role::debris, &SceneObject::role);
    };
    EXPECT_EQ(debris(wing.before), 0);
    EXPECT_GT(debris(wing.after), 3);
    EXPECT_EQ(wing.before.objects.size() + static_cast<std::size_t>(debris(wing.after)),
              wing.after.objects.size());
  }
}

TEST(MovedWing, CamerasThatStayedTurnByNothingOrByOneOrTwoSteps) {
  for (std::uint64_t seed = 1; seed < 10; ++seed) {
    const MovedWing exact = random_moved_wing(seed, CameraReturn::exact);
    EXPECT_TRUE(world_from_camera(exact.before.stand).isApprox(world_from_camera(exact.after.stand)));
    const MovedWing near = random_moved_wing(seed, CameraReturn::near);
    EXPECT_EQ(near.before.stand.base, near.after.stand.base);
    EXPECT_EQ(near.before.stand.position_m, near.after.stand.position_m);
    for (const double turn_deg : {near.before.stand.pan_deg - near.after.stand.pan_deg,
                                  near.before.stand.tilt_deg - near.after.stand.tilt_deg}) {
      const double steps = std::abs(turn_deg) / 0.325;
      EXPECT_TRUE(std::abs(steps - 1.0) < 1e-9 || std::abs(steps - 2.0) < 1e-9) << steps;
    }
  }
}

MovedTarget target(double distance_m, int visible_px, bool big, bool seen_free) {
  MovedTarget target;
  target.target.kind = "socket";
  target.target.distance_m = distance_m;
  target.target.visible_px = visible_px;
  target.target.unhidden_px = 200.0;
  target.big = big;
  target.seen_free = seen_free;
  return target;
}

MovedInspection inspection() {
  MovedInspection inspection;
  inspection.seed = 7;
  inspection.targets = {target(0.5, 200, true, true),  target(0.5, 110, true, true),
                        target(0.5, 150, false, true), target(1.1, 200, true, true),
                        target(0.5, 200, true, false), target(0.5, 20, true, true)};
  inspection.registrations = {{"spatial", 4, 1.0, 0.1, "", 5.0},
                              {"spatial", 4, 2.0, 0.1, "", 20.0},
                              {"spatial", 4, 157.0, 0.1, "two places", 9000.0}};
  inspection.results = {{"spatial", 4, 0.05, 2, 1, 3, 2, {true, false, true, true, true, true}}};
  return inspection;
}

TEST(MovedReport, CountsWhatIsVisibleNearAndWasSeenAsFree) {
  const std::vector<MovedTally> tallies = tally({inspection(), inspection()});
  ASSERT_EQ(tallies.size(), 1U);
  const MovedTally& sum = tallies[0];
  EXPECT_EQ(sum.inspections, 2U);
  EXPECT_EQ(sum.false_when_clean, 4U);
  EXPECT_EQ(sum.false_with_debris, 2U);
  EXPECT_EQ(sum.work_findings, 6U);
  EXPECT_EQ(sum.trace_findings, 4U);
  EXPECT_EQ(sum.targets, 6U);
  EXPECT_EQ(sum.found, 4U);
  EXPECT_EQ(sum.big, 4U);
  EXPECT_EQ(sum.big_found, 2U);
  EXPECT_EQ(sum.large, 2U);
  EXPECT_EQ(sum.large_found, 2U);
}

TEST(MovedReport, SaysTheSameToAPersonAndToAProgram) {
  const std::string table = to_table({inspection()});
  EXPECT_THAT(table, testing::HasSubstr("1/2 50 %"));
  EXPECT_THAT(table,
              testing::HasSubstr("2 of 3 within 4 mm and 0.25 degrees; 1 refused; 0 trusted and wrong"));
  EXPECT_THAT(table, testing::Not(testing::ContainsRegex("[^\n]{101}")));
  const auto json = json_of({inspection()}, "some");
  EXPECT_THAT(table, testing::HasSubstr("errors within the 95 % of the stated covariance: 1/2 50 %"));
  EXPECT_EQ(json["inspections"][0]["registrations"][2]["doubt"], "two places");
  EXPECT_EQ(json["inspections"][0]["registrations"][1]["normalised"], 20.0);
  EXPECT_EQ(json["inspections"][0]["targets"].size(), 6U);
  EXPECT_EQ(json["tallies"][0]["method"], "spatial");
  EXPECT_EQ(json["tallies"][0]["big_found"], 1);
  EXPECT_EQ(json["tallies"][0]["big"], 2);
  EXPECT_EQ(json["inspections"][0]["results"][0]["found"][1], false);
}

TEST(MovedReport, StatesHowLargeACollarHasToBe) {
  constexpr std::array kinds{"collar-0.27", "collar-0.36", "collar-0.44", "collar-0.53"};
  MovedInspection collars;
  collars.results = {{"auto", 8, 0.05, 0, 0, 0, 0, {}}};
  for (std::size_t i = 0; i < 200; ++i) {
    MovedTarget one = target(i % 8 == 7 ? 1.05 : 0.7, 200, false, true);
    one.target.kind = kinds.at(i % kinds.size());
    collars.targets.push_back(one);
    collars.results[0].found.push_back(i % 4 > 0 || i % 8 == 0);  // half of the smallest
  }
  const std::vector<CollarDetection> detection = collar_detection({collars});
  ASSERT_EQ(detection.size(), 3U);
  EXPECT_EQ(detection[0].collars, 0U);
  const CollarDetection& far = detection[2];
  EXPECT_EQ(far.collars, 175U) << "those beyond a metre do not count";
  EXPECT_EQ(far.found, 150U);
  ASSERT_TRUE(far.sizes && far.sizes->a90_95_mm);
  EXPECT_GT(far.sizes->a90_mm, 0.27 * 25.4);
  EXPECT_LT(*far.sizes->a90_95_mm, 0.36 * 25.4);
  EXPECT_THAT(to_table({collars}), testing::HasSubstr("collars at 0.6 to 1.0 m: 150/175"));
  const auto json = json_of({collars}, "some")["probability_of_detection"];
  EXPECT_EQ(json[2]["a90_95_mm"], *far.sizes->a90_95_mm);
  EXPECT_FALSE(json[0].contains("a90_mm"));
}

TEST(MovedReport, IsReadBackToGoOnWith) {
  const std::string text = json_text(json_of({inspection(), inspection()}, "return near"));
  const std::vector<MovedInspection> back = moved_inspections_from_json(text, "here", "return near");
  ASSERT_EQ(back.size(), 2U);
  EXPECT_EQ(json_text(json_of(back, "return near")), text);
  EXPECT_THROW((void)moved_inspections_from_json(text, "here", "return far"), UsageError);
  EXPECT_THROW((void)moved_inspections_from_json("{}", "here", "return near"), Error);
}

TEST(MovedStudy, RefusesFalseFindingsThatCannotBeAllowed) {
  for (const std::vector<double>& allowed : {std::vector<double>{}, {0.5, 0.05}, {0.0}, {-1.0}}) {
    MovedStudyOptions options;
    options.allowed = allowed;
    EXPECT_THROW((void)run_moved_study(options, {}, {}, {}), UsageError);
  }
}

TEST(MovedStudy, RefusesCapturesThatDoNotGrow) {
  for (const std::vector<int>& captures : {std::vector<int>{}, {0}, {4, 4}, {8, 1}, {17}}) {
    MovedStudyOptions options;
    options.captures = captures;
    EXPECT_THROW((void)run_moved_study(options, {}, {}, {}), UsageError);
  }
}

}  // namespace
}  // namespace rva
