#include "detect/thesis/point_cloud.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

#include "core/error.hpp"
#include "tests/depth/stacks.hpp"

namespace rva {
namespace {

constexpr double unit_m = 0.001;

Eigen::AlignedBox3f everywhere() {
  const Eigen::Vector3f far_m = Eigen::Vector3f::Constant(std::numeric_limits<float>::max());
  return {-far_m, far_m};
}

DepthImage random_depth() {
  std::mt19937 random(7);
  return test::random_stack({61, 47, 1}, 1000, 900, 0.3, random).front();
}

TEST(Deproject, AgreesWithTheCameraPixelByPixel) {
  const DepthImage depth = random_depth();
  const Intrinsics camera = test::info_of(61, 47).depth;
  const PointCloud cloud = deproject(depth, camera, unit_m, everywhere());
  ASSERT_EQ(cloud.points_m.size(), cloud.pixels.size());
  std::size_t position = 0;
  for (std::size_t i = 0; i < depth.size(); ++i) {
    if (depth[i] == no_depth) continue;
    ASSERT_LT(position, cloud.pixels.size());
    ASSERT_EQ(cloud.pixels[position], i);
    const std::size_t row = i / 61;
    const Eigen::Vector3d wanted =
        camera.deproject({static_cast<double>(i % 61), static_cast<double>(row)}, depth[i] * unit_m);
    EXPECT_TRUE(cloud.points_m[position].cast<double>().isApprox(wanted, 1e-6));
    ++position;
  }
  EXPECT_EQ(position, cloud.pixels.size());
}

TEST(Deproject, LeavesOutWhatLiesOutsideTheBox) {
  const DepthImage depth = random_depth();
  const Intrinsics camera = test::info_of(61, 47).depth;
  const Eigen::AlignedBox3f box{Eigen::Vector3f(-0.03F, -0.02F, 0.4F), Eigen::Vector3f(0.05F, 0.01F, 1.3F)};
  const PointCloud all = deproject(depth, camera, unit_m, everywhere());
  const PointCloud cropped = deproject(depth, camera, unit_m, box);
  const auto inside =
      std::ranges::count_if(all.points_m, [&](const Eigen::Vector3f& point) { return box.contains(point); });
  EXPECT_GT(inside, 100);
  EXPECT_LT(inside, static_cast<std::ptrdiff_t>(all.points_m.size()) / 2);
  EXPECT_EQ(static_cast<std::ptrdiff_t>(cropped.points_m.size()), inside);
  EXPECT_TRUE(
      std::ranges::all_of(cropped.points_m, [&](const Eigen::Vector3f& p) { return box.contains(p); }));
}

TEST(Deproject, RefusesALensThatBendsRays) {
  Intrinsics camera = test::info_of(61, 47).depth;
  camera.distortion = Distortion::brown_conrady;
  EXPECT_THROW((void)deproject(random_depth(), camera, unit_m, everywhere()), Error);
}

}  // namespace
}  // namespace rva
