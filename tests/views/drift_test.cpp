#include "views/drift.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"

namespace rva {
namespace {

double bent(int u, int v) { return 0.2 - 0.0003 * u + 0.0002 * v + 4e-7 * u * u; }

DisparityChange drifted(int width, int height, double noise_px) {
  DisparityChange change(width, height);
  Random random(7);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      change.before_px(u, v) = 25.0F;
      change.after_px(u, v) = static_cast<float>(25.0 + bent(u, v) + noise_px * random.normal());
      change.judged(u, v) = mask_set;
    }
  }
  return change;
}

double worst(const Drift& drift) {
  const Image<float> px = drift.px();
  double worst_px = 0.0;
  for (int v = 0; v < px.height(); ++v) {
    for (int u = 0; u < px.width(); ++u)
      worst_px = std::max(worst_px, std::abs(static_cast<double>(px(u, v)) - bent(u, v)));
  }
  return worst_px;
}

TEST(Drift, FollowsASmoothField) { EXPECT_LT(worst(fit_drift(drifted(848, 480, 0.0))), 0.001); }

TEST(Drift, ARagIsNoDrift) {
  DisparityChange change = drifted(848, 480, 0.04);
  for (int v = 100; v < 400; ++v) {
    for (int u = 300; u < 600; ++u) change.after_px(u, v) += 3.0F;
  }
  EXPECT_LT(worst(fit_drift(change)), 0.01);
}

TEST(Drift, StatesItsUncertainty) {
  const Drift drift = fit_drift(drifted(848, 480, 0.04));
  const double stated_px = std::sqrt(static_cast<double>(drift.variance_px2()(424, 240)));
  // 24 x 15 blocks, medians of 512 pixels: 0.04 x 1.25 / sqrt(512) / sqrt(360 / 2.25) or so.
  EXPECT_GT(stated_px, 0.00005);
  EXPECT_LT(stated_px, 0.0006);
  EXPECT_GT(drift.variance_px2()(0, 0), drift.variance_px2()(424, 240)) << "corners are known least";
}

TEST(Drift, TooLittleIsNone) {
  const Drift drift = fit_drift(drifted(64, 64, 0.0));
  EXPECT_EQ(drift.px(), Image<float>(64, 64));
  EXPECT_EQ(drift.variance_px2(), Image<float>(64, 64));
}

TEST(Drift, WhatWasNotJudgedHasNoEffect) {
  DisparityChange change = drifted(848, 480, 0.0);
  for (int v = 0; v < 480; ++v) {
    for (int u = 0; u < 500; ++u) {
      change.judged(u, v) = 0;
      change.after_px(u, v) = 0.0F;
    }
  }
  EXPECT_LT(worst(fit_drift(change)), 0.01);
}

}  // namespace
}  // namespace rva
