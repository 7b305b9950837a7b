#include "classify/finding_model.hpp"

#include <gtest/gtest.h>

#include <set>
#include <vector>

#include "classify/finding_planes.hpp"

namespace rva {
namespace {

cv::Mat planes_of_noise(std::uint64_t seed) {
  cv::Mat planes(std::vector<int>{finding_planes, plane_px, plane_px}, CV_32F);
  cv::RNG random(seed);
  random.fill(planes, cv::RNG::UNIFORM, 0.0, 1.0);
  return planes;
}

TEST(FindingModel, ComesWithTheLibrary) {
  FindingModel model = FindingModel::shipped();
  const std::set<std::string> labels(model.labels().begin(), model.labels().end());
  EXPECT_EQ(labels.size(), model.labels().size());
  EXPECT_TRUE(labels.contains("fastener"));
  EXPECT_TRUE(labels.contains("flashlight"));
  EXPECT_EQ(model.sha256().size(), 64U);
}

TEST(FindingModel, GivesAProbabilityAndItsRuleForUnknown) {
  FindingModel model = FindingModel::shipped();
  for (std::uint64_t seed = 1; seed <= 200; ++seed) {
    const LikelyClass likely = model.classify(planes_of_noise(seed));
    ASSERT_LT(likely.number, model.labels().size());
    EXPECT_GE(likely.probability, 0.0);
    EXPECT_LE(likely.probability, 1.0);
    EXPECT_EQ(likely.unknown, likely.probability < model.least_probability());
  }
}

TEST(FindingModel, GivesTheSameForTheSame) {
  FindingModel model = FindingModel::shipped();
  const cv::Mat planes = planes_of_noise(7);
  const LikelyClass first = model.classify(planes);
  (void)model.classify(planes_of_noise(8));
  const LikelyClass again = model.classify(planes);
  EXPECT_EQ(first.number, again.number);
  EXPECT_EQ(first.probability, again.probability);
}

}  // namespace
}  // namespace rva
