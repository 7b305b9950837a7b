#include "inspect/review_pictures.hpp"

#include <gtest/gtest.h>

namespace rva {
namespace {

const Intrinsics camera{64, 48, 60.0, 60.0, 31.5, 23.5};

ColorImage checked() {
  ColorImage image(camera.width, camera.height);
  for (int v = 0; v < image.height(); ++v) {
    for (int u = 0; u < image.width(); ++u)
      image(u, v) = {static_cast<std::uint8_t>(4 * u), static_cast<std::uint8_t>(5 * v), 99};
  }
  return image;
}

TEST(SeenFrom, TheSamePoseTheImageIsTheSame) {
  const ColorImage image = checked();
  EXPECT_EQ(seen_from(image, camera, Transform::Identity(), camera, Image<float>(64, 48, 0.7F)), image);
}

// A camera 0.1 m to the right sees a wall at one metre six pixels further left.
TEST(SeenFrom, ElsewhereAWallIsShiftedByItsParallax) {
  const ColorImage image = checked();
  Transform camera_from_view = Transform::Identity();
  camera_from_view.translation().x() = 0.1;
  const ColorImage seen = seen_from(image, camera, camera_from_view, camera, Image<float>(64, 48, 1.0F));
  EXPECT_EQ(seen(20, 30), image(26, 30));
  EXPECT_EQ(seen(63, 30), Rgb{}) << "beyond the image";
}

TEST(SeenFrom, WhereNothingWasMeasuredTheUsualDepthIsTaken) {
  const ColorImage image = checked();
  Transform camera_from_view = Transform::Identity();
  camera_from_view.translation().x() = 0.1;
  Image<float> depth_m(64, 48, 1.0F);
  depth_m(20, 30) = 0.0F;
  EXPECT_EQ(seen_from(image, camera, camera_from_view, camera, depth_m)(20, 30), image(26, 30));
}

}  // namespace
}  // namespace rva
