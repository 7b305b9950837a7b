#include <gtest/gtest.h>

#include <cmath>

#include "core/random.hpp"
#include "sim/sensor/surface_light.hpp"

namespace rva {
namespace {

Material matt(double grain, double grain_m) { return {"test", 0.5, 0.0, 1, grain, grain_m, Rgb{}}; }

TEST(Grain, HasTheMaterialsContrastAroundOne) {
  for (const double contrast : {0.02, 0.05, 0.15, 0.2}) {
    const Material grainy = matt(contrast, 0.002);
    Random random(3);
    double sum = 0.0;
    double squares = 0.0;
    constexpr int places = 50000;
    for (int i = 0; i < places; ++i) {
      const Eigen::Vector3d place(random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1));
      const auto value = static_cast<double>(grain_at(grainy, place.cast<float>()));
      sum += value / places;
      squares += value * value / places;
    }
    EXPECT_NEAR(sum, 1.0, 0.1 * contrast);
    EXPECT_NEAR(std::sqrt(squares - sum * sum), contrast, 0.3 * contrast);
  }
}

TEST(Grain, IsNeverNegative) {
  const Material coarse = matt(1.0, 0.005);
  for (float x = -1.0F; x < 1.0F; x += 0.001F) {
    const Eigen::Vector3f place(x, 0.3F, -0.7F);
    EXPECT_GE(grain_at(coarse, place), 0.0F);
  }
}

TEST(Dirt, DarkensAndIsNotTheSameEverywhere) {
  Material dirty = matt(0.0, 0.001);
  dirty.dirt = 0.6;
  float least = 1.0F;
  float most = 0.0F;
  for (int i = 0; i < 2000; ++i) {
    const float light = grain_at(dirty, {0.003F * static_cast<float>(i), 0.1F, 0.2F});
    least = std::min(least, light);
    most = std::max(most, light);
  }
  EXPECT_GE(least, 0.3999F) << "a share of dirt, at most";
  EXPECT_LT(least, 0.6F);
  EXPECT_GT(most, 0.9F);
  EXPECT_LE(most, 1.0F);
}

TEST(Grain, WithoutContrastIsOne) { EXPECT_EQ(grain_at(matt(0.0, 0.001), {0.1F, 0.2F, 0.3F}), 1.0F); }

TEST(Grain, IsAsCoarseAsTheMaterialStates) {
  const Material grainy = matt(0.1, 0.004);
  const auto change_over = [&grainy](double step_m) {
    double sum = 0.0;
    Random random(4);
    for (int i = 0; i < 5000; ++i) {
      const Eigen::Vector3d place(random.uniform(-1, 1), random.uniform(-1, 1), 0.25);
      const Eigen::Vector3d beside = place + Eigen::Vector3d(step_m, 0, 0);
      sum += static_cast<double>(
          std::abs(grain_at(grainy, place.cast<float>()) - grain_at(grainy, beside.cast<float>())));
    }
    return sum / 5000;
  };
  EXPECT_LT(change_over(0.0004), 0.3 * change_over(0.04));
  EXPECT_GT(change_over(0.004), 0.7 * change_over(0.04));
}

}  // namespace
}  // namespace rva
