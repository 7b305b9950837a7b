#include "evaluate/report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "core/json_object.hpp"
#include "evaluate/evaluation_json.hpp"

namespace rva {
namespace {

SimulatedInspection inspection(std::uint64_t seed, bool small_found, std::size_t false_when_clean) {
  SimulatedInspection inspection;
  inspection.seed = seed;
  inspection.targets = {{"collar-0.27", 9, 9.0, 0.9, {1}},
                        {"key", 100, 100.0, 0.5, {2}},
                        {"collar-0.27", 2, 9.0, 0.5, {3}},   // hidden
                        {"collar-0.27", 9, 9.0, 1.1, {4}}};  // too far to count as small
  inspection.targets[1].shown_px = 50;
  inspection.results = {{10,
                         {"gaussian", 3.0},
                         false_when_clean,
                         1,
                         {small_found, true, true, true},
                         {false, true, true, false}}};
  return inspection;
}

TEST(Tally, CountsWhatIsVisible) {
  const std::vector<Tally> tallies = tally({inspection(1, true, 0), inspection(2, false, 3)});
  ASSERT_EQ(tallies.size(), 1);
  const Tally& sum = tallies[0];
  EXPECT_EQ(sum.inspections, 2);
  EXPECT_EQ(sum.false_when_clean, 3);
  EXPECT_EQ(sum.false_with_debris, 2);
  EXPECT_EQ(sum.targets, 6) << "three of four, twice";
  EXPECT_EQ(sum.found, 5);
  EXPECT_EQ(sum.found_when_clean, 2) << "one visible, twice";
  EXPECT_EQ(sum.shown_targets, 2);
  EXPECT_EQ(sum.shown_found, 2);
  EXPECT_EQ(sum.small_shown_targets, 0);
  EXPECT_EQ(sum.small_targets, 2);
  EXPECT_EQ(sum.small_found, 1);
  EXPECT_EQ(sum.all_found, 1);
}

TEST(Report, SaysTheSameToAPersonAndToAProgram) {
  const std::vector<SimulatedInspection> inspections{inspection(7, true, 0), inspection(8, false, 3)};
  const std::vector<Tally> tallies = tally(inspections);
  EXPECT_THAT(to_table(tallies), testing::HasSubstr("1.5 (0.31-4.4)"));
  EXPECT_THAT(to_table(tallies), testing::HasSubstr("5/6 83 % (36-100)"));
  const auto json = json_of(Evaluation{"bay.yaml", "d435", "", inspections});
  EXPECT_EQ(json["format"], "rva-evaluation");
  EXPECT_EQ(json["tallies"][0]["found"], 5);
  EXPECT_EQ(json["inspections"][1]["seed"], 8);
  EXPECT_EQ(json["inspections"][1]["results"][0]["found"][0], false);
  EXPECT_EQ(json["inspections"][1]["targets"][2]["visible_px"], 2);
}

TEST(EvaluationJson, ComesBackAsItWas) {
  const std::string text = json_text(
      json_of(Evaluation{"bay.yaml", "random:3", "dirt", {inspection(7, true, 0), inspection(8, false, 3)}}));
  const Evaluation evaluation = evaluation_from_json(text, "evaluation.json");
  EXPECT_EQ(evaluation.scene, "bay.yaml");
  EXPECT_EQ(evaluation.cameras, "random:3");
  EXPECT_EQ(evaluation.bay, "dirt");
  EXPECT_EQ(evaluation.inspections.at(1).results.at(0).detector, (Detector{"gaussian", 3.0}));
  EXPECT_EQ(json_text(json_of(evaluation)), text);
}

TEST(EvaluationJson, SaysWhatIsWrong) {
  const std::string good = json_text(json_of(Evaluation{"", "d435", "", {inspection(7, true, 0)}}));
  auto without_targets = nlohmann::json::parse(good);
  without_targets["inspections"][0]["targets"].clear();
  auto text_for_seed = nlohmann::json::parse(good);
  text_for_seed["inspections"][0]["seed"] = "seven";
  auto too_short = nlohmann::json::parse(good);
  too_short["inspections"][0]["results"][0]["found_when_clean"].erase(0);
  for (const std::string& bad : {std::string("{"), std::string("[]"), std::string("{}"), good.substr(0, 300),
                                 without_targets.dump(), text_for_seed.dump(), too_short.dump()})
    EXPECT_THROW((void)evaluation_from_json(bad, "evaluation.json"), Error) << bad;
}

TEST(Study, GoesOnOnlyWithWhatItBegan) {
  StudyOptions options;
  options.inspections = 1;
  options.frames = {10};
  options.first_seed = 7;
  SimulatedInspection whole{7, {}, {}};
  for (const Detector& detector : detectors_to_compare())
    whole.results.push_back({10, detector, 0, 0, {}, {}});
  EXPECT_EQ(run_study(options, std::nullopt, {whole}, {}, {}).size(), 1) << "nothing is left to do";
  SimulatedInspection other_seed = whole;
  other_seed.seed = 8;
  SimulatedInspection other_frames = whole;
  other_frames.results.back().frames = 20;
  SimulatedInspection incomplete = whole;
  incomplete.results.pop_back();
  for (const SimulatedInspection& other : {other_seed, other_frames, incomplete, inspection(7, true, 0)})
    EXPECT_THROW((void)run_study(options, std::nullopt, {other}, {}, {}), UsageError);
}

TEST(Study, RefusesFramesThatDoNotGrow) {
  for (const std::vector<int>& frames : {std::vector<int>{}, {1, 10}, {10, 10}, {40, 10}, {10, 100000}}) {
    StudyOptions options;
    options.frames = frames;
    EXPECT_THROW((void)run_study(options, std::nullopt, {}, {}, {}), UsageError);
  }
}

}  // namespace
}  // namespace rva
