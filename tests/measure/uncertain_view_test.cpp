#include "measure/uncertain_view.hpp"

#include <gtest/gtest.h>

#include "tests/measure/known_view.hpp"

namespace rva {
namespace {

constexpr StereoScale stereo{21.25, 0.001};
constexpr Intrinsics camera{4, 1, 425.0, 425.0, 1.5, 0.0};

DepthStatistics statistics(const std::vector<std::vector<std::uint16_t>>& frames) {
  DepthStatistics all(4, 1);
  for (const std::vector<std::uint16_t>& frame : frames) {
    DepthImage image(4, 1);
    std::ranges::copy(frame, image.pixels().begin());
    all.add(image);
  }
  return all;
}

TEST(UncertainView, OneFrameHasTheAssumedErrors) {
  const UncertainView view = uncertain_view(statistics({{500, 1000, 0, 2000}}), camera, stereo, {});
  EXPECT_FLOAT_EQ(view.disparity_px(0, 0), 42.5F);
  EXPECT_NEAR(view.uncertainty_px(0, 0), std::hypot(0.1, 0.03), 1e-6);
  EXPECT_FALSE(view.seen(2, 0)) << "no measurement";
  EXPECT_EQ(view.uncertainty_px(2, 0), 0.0F);
  EXPECT_FALSE(view.seen(4, 0));
}

TEST(UncertainView, TheDeviationOverTimeIsThatOfASampleOfAtMostFourFrames) {
  // 499 and 501 in turn: the sample variance is n / (n - 1) square units.
  std::vector<std::vector<std::uint16_t>> frames;
  for (int i = 0; i < 20; ++i) frames.push_back(std::vector<std::uint16_t>(4, i % 2 == 0 ? 499 : 501));
  const double px_per_unit = 21250.0 / (500.0 * 500.0);
  const UncertainView view = uncertain_view(statistics(frames), camera, stereo, {});
  const double over_time_px2 = px_per_unit * px_per_unit * 20.0 / 19.0 / 4.0;
  EXPECT_NEAR(view.uncertainty_px(1, 0), std::sqrt(0.1 * 0.1 + over_time_px2), 1e-6);
}

TEST(UncertainView, RoundingIsTheLeastFixedError) {
  MeasureOptions exact;
  exact.matching_px = 0.0;
  exact.frame_px = 0.0;
  const UncertainView view = uncertain_view(statistics({{500, 500, 500, 500}}), camera, stereo, exact);
  EXPECT_NEAR(view.uncertainty_px(0, 0), 21250.0 / (500.0 * 500.0) / std::sqrt(12.0), 1e-6);
}

TEST(UncertainView, ErrorsOfAMatchersWindowHaveTheStatedCorrelation) {
  Random random(7);
  double product = 0.0;
  double square = 0.0;
  for (int trial = 0; trial < 40; ++trial) {
    const Image<float> error = test::matching_error(random, 1.0);
    for (int v = 0; v + 3 < test::view_height; v += 6) {
      for (int u = 0; u + 5 < test::view_width; u += 6) {
        product += error(u, v) * error(u + 5, v + 3);
        square += error(u, v) * error(u, v);
      }
    }
  }
  const UncertainView view = test::view_of(test::plane({0, 0, 2}));
  EXPECT_NEAR(view.correlation(5, -3), 6.0 / 11.0 * 8.0 / 11.0, 1e-12);
  EXPECT_NEAR(product / square, view.correlation(5, 3), 0.05);
  EXPECT_EQ(view.correlation(11, 0), 0.0);
  EXPECT_EQ(view.correlation(0, 0), 1.0);
}

}  // namespace
}  // namespace rva
