#include "infrared/dot_free_image.hpp"

#include <gtest/gtest.h>

#include <numbers>
#include <vector>

#include "tests/infrared/dotted_wall.hpp"

namespace rva {
namespace {

constexpr int field_end = 250;  // the projector's field ends at this column
constexpr int hole_from = 90;   // and a hole that no dot shows in reaches from here
constexpr int hole_to = 150;

// Dots of 5 x 5 pixels, but for beyond the field and in the hole.
InfraredView view_of(double pan_deg) {
  InfraredView view;
  view.log_image = Image<float>(test::wall_camera.width, test::wall_camera.height);
  view.dots = Mask(test::wall_camera.width, test::wall_camera.height);
  for (int v = 0; v < test::wall_camera.height; ++v) {
    for (int u = 0; u < field_end; ++u) {
      const Eigen::Vector2d from = test::from_dot(u, v);
      const bool in_hole = u >= hole_from && u < hole_to && v >= hole_from && v < hole_to;
      if (!in_hole && from.cwiseAbs().maxCoeff() < 2.5) view.dots(u, v) = mask_set;
    }
  }
  view.view_from_reference =
      Transform(Eigen::AngleAxisd(pan_deg * std::numbers::pi / 180.0, Eigen::Vector3d::UnitY()));
  return view;
}

int lit_columns(const Mask& lit, int v, int first, int end) {
  int count = 0;
  for (int u = first; u < end; ++u) count += lit(u, v) != 0 ? 1 : 0;
  return count;
}

// The imager's own level is no brightness of the surface, and what is cut off neither.
TEST(InfraredView, CoversUnderALampWhatIsDarkOrSaturated) {
  const std::vector<float> greys{0.0F, 1.3F, 2.9F, 3.1F, 40.0F, 249.0F, 251.0F, 255.0F};
  const std::vector<bool> covered{true, true, true, false, false, false, true, true};
  for (const float scale : {0.5F, 1.0F, 4.0F}) {
    Image<float> grey(static_cast<int>(greys.size()), 1);
    for (std::size_t i = 0; i < greys.size(); ++i) grey[i] = greys[i];
    const InfraredView view(grey, Transform::Identity(), Light::lamp, scale);
    for (std::size_t i = 0; i < greys.size(); ++i) EXPECT_EQ(view.dots[i] != 0, covered[i]) << greys[i];
  }
}

TEST(LitInAll, EndsWithinTheProjectorsField) {
  const Mask lit = lit_in_all(test::wall_surface(), std::vector{view_of(0.0)});
  for (int v = 20; v < test::wall_camera.height - 20; v += 5) {
    EXPECT_EQ(lit_columns(lit, v, field_end - 2, test::wall_camera.width), 0) << v;
    EXPECT_EQ(lit_columns(lit, v, 160, field_end - 16), field_end - 16 - 160) << v;
  }
}

// A degree is seven pixels of this camera.
TEST(LitInAll, EndsWhereTheFieldOfAnyViewDoes) {
  for (const double pan_deg : {-1.0, 1.0}) {
    const Mask lit = lit_in_all(test::wall_surface(), std::vector{view_of(0.0), view_of(pan_deg)});
    const Mask turned = lit_in_all(test::wall_surface(), std::vector{view_of(pan_deg)});
    const Mask still = lit_in_all(test::wall_surface(), std::vector{view_of(0.0)});
    for (std::size_t i = 0; i < lit.size(); ++i) ASSERT_EQ(lit[i], turned[i] & still[i]);
    EXPECT_NE(turned, still);
  }
}

TEST(LitInAll, ReachesUpToAHole) {
  const Mask lit = lit_in_all(test::wall_surface(), std::vector{view_of(0.0)});
  for (int v = hole_from + 20; v < hole_to - 20; v += 5) {
    EXPECT_EQ(lit_columns(lit, v, hole_to + 3, hole_to + 43), 40) << v;
    EXPECT_EQ(lit(120, v), 0);
  }
}

}  // namespace
}  // namespace rva
