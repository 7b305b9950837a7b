#include "capture/recording/static_transforms.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "core/error.hpp"

namespace rva {
namespace {

Transform motion(double x, double angle) {
  return Transform(Eigen::Translation3d(x, 0.1, -0.2) * Eigen::AngleAxisd(angle, Eigen::Vector3d::UnitY()));
}

TEST(StaticTransforms, AreChainedInBothDirections) {
  const Transform base_from_depth = motion(0.3, 0.2);
  const Transform base_from_color = motion(0.315, 0.21);
  const Transform color_from_optical = motion(0.0, 1.5);
  const std::vector<StaticTransform> transforms{{"color", "optical", color_from_optical},
                                                {"base", "color", base_from_color},
                                                {"base", "depth", base_from_depth}};
  const auto found = transform_between(transforms, "optical", "depth");
  ASSERT_TRUE(found);
  const Transform wanted = color_from_optical.inverse() * base_from_color.inverse() * base_from_depth;
  EXPECT_TRUE(found->isApprox(wanted, 1e-12));
  EXPECT_TRUE(transform_between(transforms, "depth", "optical")->isApprox(wanted.inverse(), 1e-12));
}

TEST(StaticTransforms, AreEmptyWithoutAConnection) {
  const std::vector<StaticTransform> transforms{{"a", "b", motion(1, 0)}, {"c", "d", motion(1, 0)}};
  EXPECT_FALSE(transform_between(transforms, "a", "d"));
  EXPECT_FALSE(transform_between({}, "a", "d"));
  EXPECT_TRUE(transform_between({}, "a", "a")->isApprox(Transform::Identity()));
}

TEST(StaticTransforms, EndInLoops) {
  const std::vector<StaticTransform> transforms{
      {"a", "b", motion(1, 0)}, {"b", "a", motion(2, 0)}, {"b", "b", motion(3, 0)}};
  EXPECT_FALSE(transform_between(transforms, "a", "c"));
}

TEST(StaticTransforms, RefuseNumbersThatAreNoRotation) {
  EXPECT_NO_THROW(static_cast<void>(transform_from_ros({1, 2, 3, 0, 0, 0, 1}, "file")));
  EXPECT_THROW(static_cast<void>(transform_from_ros({1, 2, 3, 0, 0, 0, 0}, "file")), Error);
  EXPECT_THROW(static_cast<void>(transform_from_ros({NAN, 2, 3, 0, 0, 0, 1}, "file")), Error);
}

}  // namespace
}  // namespace rva
