#include "measure/profile.hpp"

#include <gtest/gtest.h>

#include "tests/measure/known_view.hpp"

namespace rva {
namespace {

Profile profile_of(const UncertainView& view, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
  return std::get<Profile>(profile_along(view, from, to, {}));
}

TEST(Profile, OfAPlaneIsFlat) {
  const UncertainView view = test::view_of(test::plane({0.5, -0.3, 2.0}));
  const Profile profile = profile_of(view, {20, 30}, {120, 90});
  ASSERT_EQ(profile.samples.size(), 118U) << "a pixel apart, both ends included";
  EXPECT_EQ(profile.samples.front().share, 0.0);
  EXPECT_EQ(profile.samples.back().share, 1.0);
  for (const ProfileSample& sample : profile.samples) {
    ASSERT_TRUE(sample.point);
    EXPECT_NEAR(sample.point->height.value_mm, 0.0, 1e-3);
  }
  EXPECT_NEAR(profile.samples.back().point->along_mm, profile.length.value_mm, 1e-3);
}

TEST(Profile, AStepHasItsHeightAndGapsStayEmpty) {
  // A wall at 0.5 m; a bar 20 mm before it; no depth on a strip beside the bar.
  const UncertainView view = test::view_of([](const Eigen::Vector3d& ray) {
    if (std::abs(ray.x()) < 0.06) return 0.48;
    return ray.x() > 0.1 && ray.x() < 0.15 ? 0.0 : 0.5;
  });
  const Profile profile = profile_of(view, {30, 60}, {130, 60});
  const auto at = [&](double u) { return profile.samples[static_cast<std::size_t>(u - 30)]; };
  EXPECT_NEAR(at(80).point->height.value_mm, 20.0, 0.1);
  EXPECT_NEAR(at(50).point->height.value_mm, 0.0, 0.1);
  EXPECT_NEAR(at(80).point->along_mm, (80.0 - 79.5) / 200.0 * 480.0 + (79.5 - 30.0) / 200.0 * 500.0, 0.1);
  EXPECT_FALSE(at(104).point) << "the strip without depth";
  EXPECT_GT(at(80).point->height.uncertainty_mm, 0.0);
}

TEST(Profile, LongLinesHaveNoMoreSamplesThanAreDrawn) {
  UncertainView view = test::view_of(test::plane({0, 0, 2}));
  const Profile profile = profile_of(view, {0, 0}, {159, 119});
  EXPECT_LE(profile.samples.size(), 400U);
  EXPECT_EQ(profile.samples.size(), 200U);
}

TEST(Profile, EndsThatCannotBeMeasuredAreRefused) {
  const UncertainView view =
      test::view_of([](const Eigen::Vector3d& ray) { return ray.x() > 0.2 ? 0.0 : 0.5; });
  EXPECT_EQ(std::get<Unmeasured>(profile_along(view, {20, 60}, {140, 60}, {})), Unmeasured::missing_depth);
  EXPECT_EQ(std::get<Unmeasured>(profile_along(view, {-20, 60}, {40, 60}, {})), Unmeasured::outside);
  EXPECT_EQ(std::get<Unmeasured>(profile_along(view, {40, 60}, {40, 60}, {})), Unmeasured::collinear);
}

}  // namespace
}  // namespace rva
