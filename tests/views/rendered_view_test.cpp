#include "views/rendered_view.hpp"

#include <gtest/gtest.h>

#include "tests/views/box_room.hpp"

namespace rva {
namespace {

using test::bay;
using test::pose;
using test::view_of;

TEST(RenderedView, IsWhatTheOtherCameraSees) {
  const Transform from = pose(0.1, 0.0, -3);
  const Transform to = pose(0.0, 0.05, 2);
  const DepthView view = view_of(bay(), from);
  const DepthView seen = view_of(bay(), to);
  const Image<float> rendered = render(view, seen.camera, seen.stereo, to.inverse() * from);
  int compared = 0;
  int same = 0;
  for (std::size_t i = 0; i < rendered.size(); ++i) {
    if (rendered[i] <= 0.0F) continue;
    ++compared;
    same += std::abs(rendered[i] - seen.disparity_px[i]) < 0.02F ? 1 : 0;
  }
  EXPECT_GT(compared, 0.6 * static_cast<double>(rendered.size()));
  EXPECT_GT(same, 0.97 * compared) << "but for edges, and what the new view hides or first uncovers";
}

TEST(RenderedView, ShowsTheNearestAndNothingFromBehind) {
  const test::Room room{{test::box(-9, 9, -9, 9, 1.0, 1.1), test::box(-0.1, 0.1, -0.1, 0.1, 0.6, 0.65)}};
  const DepthView view = view_of(room, pose(0, 0, 0, 0));
  const Transform aside = pose(0.15, 0, 0, 0);
  const Image<float> rendered = render(view, view.camera, view.stereo, aside.inverse() * pose(0, 0, 0, 0));
  const auto wall_px = static_cast<float>(view.stereo.disparity_px(1.0));
  const auto box_px = static_cast<float>(view.stereo.disparity_px(0.6));
  const auto at = [&](double x, double z) {
    const Eigen::Vector2d pixel = view.camera.project({x - 0.15, 0.0, z});
    return rendered(static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y())));
  };
  EXPECT_NEAR(at(0.0, 0.6), box_px, 0.01);
  EXPECT_NEAR(at(0.5, 1.0), wall_px, 0.01);
  EXPECT_EQ(at(0.12, 1.0), 0.0F) << "hidden behind the box from where it was seen";
  const Transform behind(Eigen::Translation3d(0, 0, 3.0) *
                         Eigen::AngleAxisd(std::numbers::pi, Eigen::Vector3d::UnitY()));
  const Image<float> back = render(view, view.camera, view.stereo, behind.inverse() * pose(0, 0, 0, 0));
  for (const float disparity_px : back.pixels()) EXPECT_EQ(disparity_px, 0.0F);
}

}  // namespace
}  // namespace rva
