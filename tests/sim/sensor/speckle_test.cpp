#include "sim/sensor/speckle.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <vector>

namespace rva {
namespace {

constexpr int width = 120;
constexpr int height = 96;

StereoSensorOptions with(double speckle, double wander, double levels) {
  StereoSensorOptions options;
  options.speckle = speckle;
  options.wander = wander;
  options.levels = levels;
  return options;
}

using Field = std::vector<float>;

Field field_of(const Speckle& speckle, int columns = width, int rows = height) {
  Field field;
  Field row(static_cast<std::size_t>(columns));
  for (int v = 0; v < rows; ++v) {
    speckle.row(v, row.data());
    field.insert(field.end(), row.begin(), row.end());
  }
  return field;
}

Field frame(const StereoSensorOptions& options, std::uint64_t view, std::uint64_t capture, int number = 0) {
  Speckle speckle(width, height, options, {{view, 1.0}}, capture);
  for (int k = 0; k <= number; ++k) speckle.advance();
  return field_of(speckle);
}

/// Mean product of what two fields have beyond 1.
double covariance(const Field& a, const Field& b) {
  double sum = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    sum += (static_cast<double>(a[i]) - 1.0) * (static_cast<double>(b[i]) - 1.0);
  return sum / static_cast<double>(a.size());
}

double correlation(const Field& a, const Field& b) {
  return covariance(a, b) / std::sqrt(covariance(a, a) * covariance(b, b));
}

TEST(Speckle, IsOneOnAverage) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    double sum = 0.0;
    for (const float factor : frame({}, seed, seed + 10, 3)) sum += static_cast<double>(factor);
    EXPECT_NEAR(sum / (width * height), 1.0, 0.006);
  }
}

TEST(Speckle, HasTheContrastsOfTheOptions) {
  for (const double contrast : {0.05, 0.2}) {
    const Field fixed = frame(with(contrast, 0, 0), 1, 2);
    const Field levels = frame(with(0, 0, contrast), 1, 2);
    EXPECT_NEAR(std::sqrt(covariance(fixed, fixed)), contrast, 0.05 * contrast);
    EXPECT_NEAR(std::sqrt(covariance(levels, levels)), contrast, 0.05 * contrast);
    // The wandering part's weights differ between captures: its contrast is one of many of them.
    double variance = 0.0;
    for (std::uint64_t capture = 0; capture < 100; ++capture) {
      const Field wandering = frame(with(0, contrast, 0), 1, capture);
      variance += covariance(wandering, wandering) / 100.0;
    }
    EXPECT_NEAR(std::sqrt(variance), contrast, 0.1 * contrast);
  }
}

TEST(Speckle, IsNeverNegative) {
  for (const float factor : frame(with(1, 1, 1), 1, 2)) ASSERT_GE(factor, 0.0F);
}

TEST(Speckle, IsNothingWithoutItsParts) {
  for (const float factor : frame(with(0, 0, 0), 1, 2)) ASSERT_EQ(factor, 1.0F);
}

TEST(Speckle, FollowsFromItsTwoSeeds) {
  EXPECT_EQ(frame({}, 1, 2, 5), frame({}, 1, 2, 5));
  EXPECT_NE(frame({}, 1, 2, 5), frame({}, 1, 3, 5));
  EXPECT_NE(frame({}, 1, 2, 5), frame({}, 2, 2, 5));
  EXPECT_NE(frame({}, 1, 2, 5), frame({}, 1, 2, 6));
}

TEST(Speckle, TwoCapturesOfAViewShareWhatStays) {
  EXPECT_EQ(frame(with(0.09, 0, 0), 1, 2), frame(with(0.09, 0, 0), 1, 3, 7));
  EXPECT_GT(correlation(frame({}, 1, 2), frame({}, 1, 3)), 0.4);
  EXPECT_LT(std::abs(correlation(frame({}, 1, 2), frame({}, 2, 2))), 0.05);
}

TEST(Speckle, BecomesAnotherAsTheCameraTurns) {
  constexpr double turn_deg = 0.2;
  const auto turned = [](const PanTilt& joints) {
    Speckle speckle(width, height, with(0.09, 0, 0), speckle_shares(joints, turn_deg, 7), 2);
    speckle.advance();
    return field_of(speckle);
  };
  // Over many poses, since how much two of them share depends on where they lie between the grid's points.
  double like_itself = 0.0;
  double a_little = 0.0;
  double more = 0.0;
  constexpr int poses = 12;
  for (int k = 0; k < poses; ++k) {
    const PanTilt joints{-3.0 + 0.37 * k, 1.0 - 0.23 * k};
    const Field here = turned(joints);
    EXPECT_NEAR(std::sqrt(covariance(here, here)), 0.09, 0.05 * 0.09) << "the contrast is the same anywhere";
    like_itself += correlation(here, turned(joints)) / poses;
    a_little += correlation(here, turned({joints.pan_deg + 0.25 * turn_deg, joints.tilt_deg})) / poses;
    more += correlation(here, turned({joints.pan_deg + turn_deg, joints.tilt_deg})) / poses;
    EXPECT_LT(std::abs(correlation(here, turned({joints.pan_deg + 2.0 * turn_deg, joints.tilt_deg}))), 0.05);
  }
  EXPECT_NEAR(like_itself, 1.0, 1e-6);
  EXPECT_GT(a_little, 0.8);
  EXPECT_LT(a_little, 0.98);
  EXPECT_GT(more, 0.1);
  EXPECT_LT(more, 0.6);
}

TEST(Speckle, NeighboursAreIndependent) {
  const Field field = frame(with(0.09, 0, 0), 1, 2);
  const Field right(field.begin() + 1, field.end());
  const Field below(field.begin() + width, field.end());
  EXPECT_LT(std::abs(correlation(right, Field(field.begin(), field.end() - 1))), 0.05);
  EXPECT_LT(std::abs(correlation(below, Field(field.begin(), field.end() - width))), 0.05);
}

TEST(Speckle, WandersOverAsManyFramesAsTheOptionStates) {
  StereoSensorOptions options = with(0, 0.1, 0);
  options.wander_frames = 10.0;
  constexpr std::size_t lags[] = {0, 5, 10, 20, 40};
  double covariances[5] = {};
  for (std::uint64_t capture = 0; capture < 8; ++capture) {
    Speckle speckle(12, 12, options, {{capture, 1.0}}, capture);
    std::vector<Field> frames;
    for (int k = 0; k < 1500; ++k) {
      speckle.advance();
      frames.push_back(field_of(speckle, 12, 12));
    }
    for (std::size_t i = 0; i < 5; ++i) {
      for (std::size_t k = 40; k < frames.size(); ++k)
        covariances[i] += covariance(frames[k], frames[k - lags[i]]);
    }
  }
  for (std::size_t i = 0; i < 5; ++i)
    EXPECT_NEAR(covariances[i] / covariances[0], std::exp(-static_cast<double>(lags[i]) / 10.0), 0.1)
        << lags[i];
}

TEST(Speckle, JumpsBetweenThreeLevelsAndHoldsThem) {
  StereoSensorOptions options = with(0, 0, 0.05);
  options.level_frames = 20.0;
  Speckle speckle(width, height, options, {{1, 1.0}}, 2);
  constexpr int frames = 1000;
  constexpr std::size_t patch_px = 12;
  std::vector<std::set<float>> values(width / patch_px * height / patch_px);
  std::vector<float> last(values.size());
  int jumps = 0;
  for (int k = 0; k < frames; ++k) {
    speckle.advance();
    const Field field = field_of(speckle);
    for (std::size_t patch = 0; patch < values.size(); ++patch) {
      const std::size_t across = width / patch_px;
      const float value = field[(patch / across * width + patch % across) * patch_px];
      jumps += k > 0 && value != last[patch] ? 1 : 0;
      last[patch] = value;
      values[patch].insert(value);
    }
  }
  for (const std::set<float>& levels : values) EXPECT_EQ(levels.size(), 3U);
  EXPECT_NEAR(static_cast<double>(values.size()) * (frames - 1) / jumps, 20.0, 0.1 * 20.0);
}

}  // namespace
}  // namespace rva
