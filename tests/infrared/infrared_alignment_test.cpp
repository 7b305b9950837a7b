#include "infrared/infrared_alignment.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "tests/infrared/dotted_wall.hpp"

namespace rva {
namespace {

constexpr double rad_per_deg = std::numbers::pi / 180.0;
// Beyond, misregistration costs small debris (docs/infrared.md).
constexpr double tolerated_px = 0.1;

// How far a pose puts the wall from where it is seen: root mean square over the image.
double off_px(const Transform& pose, const Transform& truth) {
  double squares = 0.0;
  int points = 0;
  for (int v = 20; v < test::wall_camera.height; v += 40) {
    for (int u = 20; u < test::wall_camera.width; u += 40) {
      const Eigen::Vector3d point = test::wall_camera.deproject({u, v}, test::wall_m);
      squares +=
          (test::wall_camera.project(pose * point) - test::wall_camera.project(truth * point)).squaredNorm();
      ++points;
    }
  }
  return std::sqrt(squares / points);
}

// Turns each pose but the first by up to half a servo step, which the servos do not notice.
void misstate(std::vector<InfraredView>& views, std::uint64_t seed) {
  Random random(seed);
  constexpr double half_a_step = 0.16 * rad_per_deg;
  for (std::size_t k = 1; k < views.size(); ++k) {
    const Eigen::Vector3d error(random.uniform(-half_a_step, half_a_step),
                                random.uniform(-half_a_step, half_a_step), 0.0);
    views[k].view_from_reference = test::turned(error) * views[k].view_from_reference;
  }
}

TEST(InfraredAlignment, FindsHowTheViewsOfASideWereTurned) {
  const std::vector<Eigen::Vector3d> turns = test::dithers(8, 5);
  std::vector<InfraredView> views = test::views_at(turns, 11);
  misstate(views, 2);
  align_side(test::wall_surface(), views);
  for (std::size_t k = 0; k < views.size(); ++k)
    EXPECT_LT(off_px(views[k].view_from_reference, test::turned(turns[k])), tolerated_px) << k;
}

// With so much noise that hardly any of an image's steepness is that of the wall.
TEST(InfraredAlignment, FindsItInTheDarkAsWell) {
  const std::vector<Eigen::Vector3d> turns = test::dithers(8, 15);
  std::vector<InfraredView> views = test::views_at(turns, 61, {.noise = 0.12});
  misstate(views, 4);
  align_side(test::wall_surface(), views);
  for (std::size_t k = 0; k < views.size(); ++k)
    EXPECT_LT(off_px(views[k].view_from_reference, test::turned(turns[k])), 1.5 * tolerated_px) << k;
}

TEST(InfraredAlignment, WhatChangedSinceDoesNotTurnTheOtherSide) {
  const std::vector<Eigen::Vector3d> turns = test::dithers(4, 6);
  const DotFreeImage before = fuse(test::wall_surface(), test::views_at(turns, 21));
  const std::vector<test::Spot> spots{{0.05, 0.02, 0.04, 0.3}, {-0.08, -0.05, 0.03, 1.6}};
  std::vector<InfraredView> after = test::views_at(turns, 22, {.brightness = 0.8}, spots);
  misstate(after, 3);
  const Eigen::Vector3d first(0.002, -0.001, 0.0);
  after.front().view_from_reference = test::turned(first);
  align_to(before, test::wall_surface(), after);
  for (std::size_t k = 0; k < after.size(); ++k)
    EXPECT_LT(off_px(after[k].view_from_reference, test::turned(turns[k])), 1.5 * tolerated_px) << k;
}

TEST(InfraredAlignment, AnImageWithoutAnythingToSeeLeavesPosesAsTheyWere) {
  std::vector<InfraredView> views;
  const Transform pose = test::turned({0.01, 0.0, 0.0});
  views.emplace_back(Image<float>(320, 240, 20.0F), Transform::Identity());
  views.emplace_back(Image<float>(320, 240, 20.0F), pose);
  align_side(test::wall_surface(), views);
  EXPECT_LT(off_px(views[1].view_from_reference, pose), 0.02);
}

}  // namespace
}  // namespace rva
