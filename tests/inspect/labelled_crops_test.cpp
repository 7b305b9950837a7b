#include "inspect/labelled_crops.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <optional>
#include <vector>

#include "classify/finding_planes.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "depth/image_file.hpp"
#include "inspect/inspection_folder.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

std::optional<Decision> decided(Verdict verdict) {
  Decision decision;
  decision.verdict = verdict;
  return decision;
}

// One comparison in which the same region was found several times, decided on as stated.
InspectionHistory history_of(const std::vector<std::optional<Decision>>& decisions) {
  InspectionHistory history;
  history.inspection.id = 7;
  ComparedRound round;
  round.comparison.number = 1;
  round.comparison.folder = InspectionFolder::comparison_name(1);
  for (const auto& decision : decisions) {
    ReviewedFinding finding;
    finding.number = static_cast<int>(round.findings.size()) + 1;
    finding.finding.box = {0, 10, 8, 6};
    finding.decision = decision;
    round.findings.push_back(finding);
  }
  history.rounds.push_back(round);
  return history;
}

std::filesystem::path result_folder(const test::TemporaryFolder& data) {
  const InspectionFolder folder(data.path(), 7);
  auto result = InspectionFolder::result_in(folder.path() / InspectionFolder::comparison_name(1), 0);
  std::filesystem::create_directories(result);
  return result;
}

TEST(LabelledCrops, HaveTheLabelOfADecisionThatIsFinal) {
  EXPECT_EQ(label_of(decided(Verdict::debris)), "debris");
  EXPECT_EQ(label_of(decided(Verdict::debris_removed)), "debris");
  EXPECT_EQ(label_of(decided(Verdict::debris_unreachable)), "debris");
  EXPECT_EQ(label_of(decided(Verdict::installed_work)), "installed-work");
  EXPECT_EQ(label_of(decided(Verdict::false_alarm)), "false-alarm");
  EXPECT_EQ(label_of(decided(Verdict::second_look)), std::nullopt);
  EXPECT_EQ(label_of(decided(Verdict::undecided)), std::nullopt);
  EXPECT_EQ(label_of(std::nullopt), std::nullopt);
}

TEST(LabelledCrops, AreOfFindingsWithALabelAndOfThePicturesThatThereAre) {
  const test::TemporaryFolder data;
  const test::TemporaryFolder out;
  write_file(result_folder(data) / "final_depth.png", encode_png(ColorImage(64, 48, {1, 2, 3})));
  const auto crops = write_labelled_crops(history_of({decided(Verdict::debris), decided(Verdict::second_look),
                                                      std::nullopt, decided(Verdict::false_alarm)}),
                                          data.path(), out.path())
                         .crops;
  ASSERT_EQ(crops.size(), 2U);
  EXPECT_EQ(crops[0]["finding"], 1);
  EXPECT_EQ(crops[1]["finding"], 4);
  for (const auto& crop : crops) {
    ASSERT_EQ(crop["files"].size(), 1U) << "no colour in darkness";
    EXPECT_EQ(read_color(out / crop["files"]["final_depth"].get<std::string>()),
              ColorImage(32, 32, {1, 2, 3}));
    EXPECT_EQ(crop["box_in_crop"], nlohmann::json({0, 10, 8, 6})) << "at the border";
  }
}

TEST(LabelledCrops, AMissingPictureIsAnError) {
  const test::TemporaryFolder data;
  const test::TemporaryFolder out;
  static_cast<void>(result_folder(data));
  EXPECT_THROW(static_cast<void>(
                   write_labelled_crops(history_of({decided(Verdict::debris)}), data.path(), out.path())),
               Error);
  EXPECT_TRUE(write_labelled_crops(history_of({std::nullopt}), data.path(), out.path()).crops.empty())
      << "which nobody needs";
}

// The planes of the second and the last finding; the first one has no class.
TEST(LabelledCrops, ForTrainingHaveWhatPeopleCalledThem) {
  const test::TemporaryFolder data;
  const test::TemporaryFolder out;
  write_file(result_folder(data) / "final_depth.png", encode_png(ColorImage(64, 48, {1, 2, 3})));
  InspectionHistory history =
      history_of({decided(Verdict::debris), decided(Verdict::debris_removed), decided(Verdict::debris),
                  decided(Verdict::second_look), decided(Verdict::false_alarm)});
  auto& findings = history.rounds.front().findings;
  findings[1].decision->object = "flashlight";
  findings[3].decision->object = "pen";
  std::vector<cv::Mat> planes;
  for (std::size_t i = 1; i < findings.size(); ++i) {
    findings[i].likely_class = "unknown";
    planes.emplace_back(std::vector<int>{finding_planes, plane_px, plane_px}, CV_32F,
                        cv::Scalar(static_cast<double>(i)));
  }
  const auto file = InspectionFolder(data.path(), 7).path() / InspectionFolder::comparison_name(1) /
                    InspectionFolder::shown_findings;
  write_file(file, npy_of(planes));
  const LabelledCrops labelled = write_labelled_crops(history, data.path(), out.path());
  ASSERT_EQ(labelled.shown.size(), 2U) << "neither a name nor a decision is known of the others";
  EXPECT_EQ(labelled.shown[0]["kind"], "flashlight");
  EXPECT_EQ(labelled.shown[0]["finding"], 2);
  EXPECT_EQ(labelled.shown[1]["kind"], "");
  EXPECT_EQ(labelled.shown[1]["finding"], 5);
  const std::size_t bytes_each = labelled.planes.size() / 2;
  cv::Mat first;
  cv::Mat(1, finding_planes * plane_px * plane_px, CV_16F, const_cast<char*>(labelled.planes.data()))
      .convertTo(first, CV_32F);
  EXPECT_EQ(bytes_each, first.total() * 2U);
  EXPECT_EQ(first.at<float>(0), 1.0F);

  write_file(file, npy_of({planes[0]}));
  EXPECT_THROW(static_cast<void>(write_labelled_crops(history, data.path(), out.path())), Error);
  write_file(file, std::string_view("none"));
  EXPECT_THROW(static_cast<void>(write_labelled_crops(history, data.path(), out.path())), Error);
}

TEST(LabelledCrops, AMissingPartOfThePlanShowsNothing) {
  const test::TemporaryFolder data;
  const test::TemporaryFolder out;
  InspectionHistory history = history_of({decided(Verdict::debris)});
  history.rounds.front().findings.front().planned = PlannedState::missing;
  EXPECT_TRUE(write_labelled_crops(history, data.path(), out.path()).crops.empty());
}

}  // namespace
}  // namespace rva
