#include "geometry/transform.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "core/error.hpp"

namespace rva {
namespace {

Transform sample() {
  Transform a_from_b = Transform::Identity();
  a_from_b.rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  a_from_b.translation() = Eigen::Vector3d(0.1, -0.2, 0.3);
  return a_from_b;
}

TEST(Transform, SurvivesItsSixteenNumbers) {
  const Transform a_from_b = sample();
  EXPECT_TRUE(from_row_major(to_row_major(a_from_b)).isApprox(a_from_b, 1e-12));
}

TEST(Transform, IsWrittenRowByRow) {
  const std::array<double, 16> numbers = to_row_major(sample());
  EXPECT_EQ(numbers[3], 0.1);
  EXPECT_EQ(numbers[7], -0.2);
  EXPECT_EQ(numbers[11], 0.3);
  EXPECT_EQ(numbers[15], 1.0);
}

TEST(Transform, RoundedNumbersGiveAnExactRotation) {
  std::array<double, 16> numbers = to_row_major(sample());
  for (double& number : numbers) number = std::round(number * 1e4) / 1e4;
  const Eigen::Matrix3d rotation = from_row_major(numbers).linear();
  EXPECT_TRUE((rotation * rotation.transpose()).isIdentity(1e-12));
  EXPECT_TRUE(rotation.isApprox(sample().linear(), 1e-3));
}

TEST(Transform, RefusesWhatIsNotRigid) {
  const std::array<double, 16> good = to_row_major(sample());
  const auto refused = [&](std::size_t index, double value) {
    std::array<double, 16> bad = good;
    bad[index] = value;
    EXPECT_THROW(static_cast<void>(from_row_major(bad)), Error) << index;
  };
  refused(0, 2.0);
  refused(3, std::nan(""));
  refused(7, HUGE_VAL);
  refused(12, 1.0);
  refused(15, 0.0);
  std::array<double, 16> mirrored = to_row_major(Transform::Identity());
  mirrored[0] = -1.0;
  EXPECT_THROW(static_cast<void>(from_row_major(mirrored)), Error);
}

}  // namespace
}  // namespace rva
