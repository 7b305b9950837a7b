#include "classify/model_outputs.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <vector>

#include "core/error.hpp"

namespace rva {
namespace {

using testing::HasSubstr;

constexpr int classes = 2;
const cv::Size size{200, 100};

// A table as a model's output of one picture.
cv::Mat output_of(const std::vector<std::vector<float>>& rows) {
  const std::vector<int> sizes{1, static_cast<int>(rows.size()), static_cast<int>(rows.front().size())};
  cv::Mat output(sizes, CV_32F);
  float* at = output.ptr<float>();
  for (const std::vector<float>& row : rows) at = std::ranges::copy(row, at).out;
  return output;
}

std::vector<std::vector<float>> transposed(const std::vector<std::vector<float>>& rows) {
  std::vector<std::vector<float>> columns(rows.front().size(), std::vector<float>(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i)
    for (std::size_t k = 0; k < rows[i].size(); ++k) columns[k][i] = rows[i][k];
  return columns;
}

std::vector<ModelObject> objects_of(const std::vector<cv::Mat>& outputs, double least = 0.3) {
  return objects_in(outputs, classes, size, least, "model");
}

void expect_object(const ModelObject& object, const cv::Rect2d& box, int label, double probability) {
  EXPECT_NEAR(object.box.x, box.x, 1e-4);
  EXPECT_NEAR(object.box.y, box.y, 1e-4);
  EXPECT_NEAR(object.box.width, box.width, 1e-4);
  EXPECT_NEAR(object.box.height, box.height, 1e-4);
  EXPECT_EQ(object.label, label);
  EXPECT_NEAR(object.probability, probability, 1e-6);
}

TEST(ModelOutputs, OfYoloRowsCountObjectnessTimesClass) {
  const auto objects = objects_of({output_of({{50, 40, 20, 10, 0.5F, 0.2F, 0.8F},
                                              {150, 60, 8, 30, 0.9F, 1.0F, 0.1F},
                                              {10, 10, 5, 5, 0.2F, 0.9F, 0.9F}})});
  ASSERT_EQ(objects.size(), 2U);
  expect_object(objects[0], {146, 45, 8, 30}, 0, 0.9);
  expect_object(objects[1], {40, 35, 20, 10}, 1, 0.4);
}

TEST(ModelOutputs, OfYoloColumnsHaveNoObjectness) {
  const auto objects = objects_of({output_of(
      transposed({{50, 40, 20, 10, 0.2F, 0.8F}, {150, 60, 8, 30, 0.9F, 0.1F}, {10, 10, 5, 5, 0.1F, 0.2F}}))});
  ASSERT_EQ(objects.size(), 2U);
  expect_object(objects[0], {146, 45, 8, 30}, 0, 0.9);
  expect_object(objects[1], {40, 35, 20, 10}, 1, 0.8);
}

TEST(ModelOutputs, OfSsdHaveABackgroundAndSharesOfThePicture) {
  const cv::Mat scores = output_of({{0.1F, 0.2F, 0.7F}, {0.9F, 0.05F, 0.05F}, {0.0F, 1.0F, 0.0F}});
  const cv::Mat boxes = output_of({{0.25F, 0.5F, 0.5F, 0.75F}, {0, 0, 1, 1}, {0.9F, 0.9F, 1.1F, 1.0F}});
  for (const auto& outputs : {std::vector{scores, boxes}, std::vector{boxes, scores}}) {
    const auto objects = objects_of(outputs);
    ASSERT_EQ(objects.size(), 2U);
    expect_object(objects[0], {180, 90, 40, 10}, 0, 1.0);
    expect_object(objects[1], {50, 50, 50, 25}, 1, 0.7);
  }
}

TEST(ModelOutputs, OfSsdWithAsManyScoresAsCornersAreToldApartByTheirSums) {
  const cv::Mat scores = output_of({{0.1F, 0.2F, 0.6F, 0.1F}, {0.9F, 0.05F, 0.03F, 0.02F}});
  const cv::Mat boxes = output_of({{0.25F, 0.5F, 0.5F, 0.75F}, {0, 0, 0.5F, 0.5F}});
  constexpr int three = 3;
  for (const auto& outputs : {std::vector{scores, boxes}, std::vector{boxes, scores}}) {
    const auto objects = objects_in(outputs, three, size, 0.3, "model");
    ASSERT_EQ(objects.size(), 1U);
    expect_object(objects[0], {50, 50, 50, 25}, 1, 0.6);
  }
}

// The same objects in all layouts: what they mean does not depend on how they are written.
TEST(ModelOutputs, OfAllLayoutsMeanTheSame) {
  const std::vector<std::vector<float>> columns{{60, 30, 40, 20, 0.75F, 0.25F},
                                                {120, 70, 10, 30, 0.125F, 0.5F}};
  std::vector<std::vector<float>> rows, scores, boxes;
  for (const auto& o : columns) {
    rows.push_back({o[0], o[1], o[2], o[3], 1.0F, o[4], o[5]});
    scores.push_back({0.0F, o[4], o[5]});
    boxes.push_back(
        {(o[0] - o[2] / 2) / 200, (o[1] - o[3] / 2) / 100, (o[0] + o[2] / 2) / 200, (o[1] + o[3] / 2) / 100});
  }
  const auto expected = objects_of({output_of(transposed(columns))});
  ASSERT_EQ(expected.size(), 2U);
  for (const auto& outputs :
       {std::vector{output_of(rows)}, std::vector{output_of(scores), output_of(boxes)}}) {
    const auto objects = objects_of(outputs);
    ASSERT_EQ(objects.size(), expected.size());
    for (std::size_t i = 0; i < objects.size(); ++i)
      expect_object(objects[i], expected[i].box, expected[i].label, expected[i].probability);
  }
}

TEST(ModelOutputs, OfOneObjectAreReportedOnce) {
  const auto objects = objects_of({output_of({{50, 50, 20, 20, 1, 0.8F, 0},
                                              {51, 50, 20, 20, 1, 0.9F, 0},
                                              {50, 50, 20, 20, 1, 0, 0.7F},
                                              {80, 50, 20, 20, 1, 0.6F, 0}})});
  ASSERT_EQ(objects.size(), 3U) << "another class, or elsewhere, is another object";
  expect_object(objects[0], {41, 40, 20, 20}, 0, 0.9);
  expect_object(objects[1], {40, 40, 20, 20}, 1, 0.7);
  expect_object(objects[2], {70, 40, 20, 20}, 0, 0.6);
}

TEST(ModelOutputs, ThatAreNoProbabilityOrNoBoxAreLeftOut) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const float infinite = std::numeric_limits<float>::infinity();
  EXPECT_TRUE(objects_of({output_of({{50, 50, 20, 20, 1, nan, nan},
                                     {nan, 50, 20, 20, 1, 1, 0},
                                     {50, 50, infinite, 20, 1, 1, 0},
                                     {50, 50, 0, 20, 1, 1, 0},
                                     {50, 50, -20, -20, 1, 1, 0},
                                     {50, 50, 20, 20, 30, 1, 0}})})
                  .empty());
}

TEST(ModelOutputs, OfOtherModelsAreRefusedWithTheirSizes) {
  const auto problem_of = [](const std::vector<cv::Mat>& outputs) -> std::string {
    try {
      static_cast<void>(objects_of(outputs));
    } catch (const Error& error) {
      return error.problem();
    }
    return {};
  };
  EXPECT_THAT(problem_of({output_of({{1, 2, 3, 4, 5, 6, 7, 8}})}), HasSubstr("1x1x8"));
  EXPECT_THAT(problem_of({output_of({{1, 2}})}), HasSubstr("2 classes"));
  EXPECT_THAT(problem_of({output_of({{1, 2, 3}}), output_of({{1, 2, 3}})}), HasSubstr("1x1x3 and 1x1x3"));
  EXPECT_THAT(problem_of({output_of({{1, 2, 3}}), output_of({{1, 2, 3, 4}, {1, 2, 3, 4}})}),
              HasSubstr("1x2x4"));
  EXPECT_THAT(problem_of({cv::Mat(std::vector<int>{1, 2, 2, 7}, CV_32F, cv::Scalar(0))}),
              HasSubstr("1x2x2x7"));
  EXPECT_THAT(problem_of({}), HasSubstr("2 classes"));
}

}  // namespace
}  // namespace rva
