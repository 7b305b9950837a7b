#include "infrared/dot_mask.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/infrared/dotted_wall.hpp"

namespace rva {
namespace {

double covered(const Mask& mask) {
  return static_cast<double>(std::ranges::count(mask.pixels(), mask_set)) / static_cast<double>(mask.size());
}

TEST(DotMask, CoversDotsAndLeavesWhatIsBetweenThem) {
  const Mask mask = dot_mask(log_grey(test::wall_seen(Eigen::Vector3d::Zero(), 1)));
  for (int v = 5; v < mask.height() - 5; v += 11) {
    for (int u = 0; u < mask.width(); ++u) {
      if (test::from_dot(u, v).norm() < 1.0) {
        EXPECT_NE(mask(u, v), 0) << u << ' ' << v;
      }
    }
  }
  EXPECT_GT(covered(mask), 0.15);
  EXPECT_LT(covered(mask), 0.65);
}

TEST(DotMask, WithoutDotsCoversNextToNothing) {
  const Mask mask = dot_mask(log_grey(test::wall_seen(Eigen::Vector3d::Zero(), 1, {.dots = 0.0})));
  EXPECT_LT(covered(mask), 0.03);
}

TEST(DotMask, NoiseOfDarkImagesIsNotTakenForDots) {
  const test::WallLight dark{.noise = 0.2, .background = 2.0, .dots = 0.0};
  EXPECT_LT(covered(dot_mask(log_grey(test::wall_seen(Eigen::Vector3d::Zero(), 3, dark)))), 0.1);
}

}  // namespace
}  // namespace rva
