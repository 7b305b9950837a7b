#include "measure/measured_picture.hpp"

#include <gtest/gtest.h>

#include "tests/measure/known_view.hpp"

namespace rva {
namespace {

// A wall at one metre, and a colour imager 15 mm to the right.
MeasuredPicture colour_of(UncertainView view) {
  PictureCamera colour{view.camera, Transform::Identity()};
  colour.picture_from_depth.translation().x() = -0.015;
  return {std::move(view), colour};
}

Eigen::Vector3d position(const MeasuredPicture& picture, const Eigen::Vector2d& pixel) {
  return std::get<SurfacePoint>(picture.point(pixel, {})).position_m;
}

TEST(MeasuredPicture, InTheDepthImageItIsThePixelItself) {
  const MeasuredPicture picture{test::view_of(test::plane({0, 0, 1})), std::nullopt};
  EXPECT_EQ(*picture.depth_pixel({30.25, 40.5}), Eigen::Vector2d(30.25, 40.5));
  EXPECT_FALSE(picture.depth_pixel({-1, 40}));
  EXPECT_NEAR(position(picture, {119.5, 59.5}).x(), 0.2, 1e-6);
}

TEST(MeasuredPicture, InColourItIsTheSurfaceThatIsSeenThere) {
  const UncertainView view = test::view_of(test::plane({0, 0, 1}));
  const MeasuredPicture by_depth{view, std::nullopt};
  EXPECT_NEAR((position(colour_of(view), {77, 60}) - position(by_depth, {80, 60})).norm(), 0.0, 1e-9)
      << "3 px of parallax at 1 m";
}

TEST(MeasuredPicture, WhereSurfacesHideEachOtherTheNearerIsSeen) {
  const MeasuredPicture picture = colour_of(test::view_of([](const Eigen::Vector3d& ray) {
    const double u = 79.5 + 200.0 * ray.x();
    return u > 69.5 && u < 89.5 ? 0.5 : 1.0;
  }));
  EXPECT_NEAR(position(picture, {74, 60}).z(), 0.5, 0.01);
}

TEST(MeasuredPicture, PixelsWithoutDepthAreDistinguishedFromThoseOutside) {
  const MeasuredPicture picture =
      colour_of(test::view_of([](const Eigen::Vector3d& ray) { return ray.x() > 0.0 ? 0.0 : 1.0; }));
  EXPECT_EQ(std::get<Unmeasured>(picture.point({120, 60}, {})), Unmeasured::missing_depth);
  EXPECT_EQ(std::get<Unmeasured>(picture.point({-9, 60}, {})), Unmeasured::outside);
  EXPECT_EQ(std::get<Unmeasured>(picture.point({std::nan(""), 60}, {})), Unmeasured::outside);
}

TEST(MeasuredPicture, ABoxOfThePictureIsARegionOfTheDepthImage) {
  const Mask region = colour_of(test::view_of(test::plane({0, 0, 1})))
                          .region({Eigen::Vector2d(20, 30), Eigen::Vector2d(24, 33)});
  EXPECT_EQ(std::ranges::count(region.pixels(), mask_set), 5 * 4);
  EXPECT_EQ(region(23, 30), mask_set);
  EXPECT_EQ(region(22, 30), 0) << "3 px of parallax";
}

}  // namespace
}  // namespace rva
