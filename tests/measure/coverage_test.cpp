// The stated uncertainty covers the truth: simulated trials with all errors that it is made of.
#include <gtest/gtest.h>

#include <functional>

#include "measure/profile.hpp"
#include "measure/quantity.hpp"
#include "tests/measure/known_view.hpp"

namespace rva {
namespace {

using test::rectangle;

const Eigen::Vector3d slanted(0.6, -0.4, 2.0);
constexpr double block_mm = 20.0;

// A slanted surface, and on it a block whose top is parallel to it.
double depth_m(const Eigen::Vector3d& ray) {
  const double top_offset = 1.0 - block_mm / 1000.0 * slanted.norm();
  const bool on_block = std::abs(ray.x()) < 0.09 && std::abs(ray.y()) < 0.09;
  return (on_block ? top_offset : 1.0) / slanted.dot(ray);
}

Eigen::Vector3d point_m(const UncertainView& view, const Eigen::Vector2d& pixel) {
  const Eigen::Vector3d ray = view.ray(pixel);
  return depth_m(ray) * ray;
}

/// One trial: a view with errors of matching, a camera of wrong scale, and a hand that taps beside its aim.
struct Trial {
  UncertainView view;
  Random random;
  MeasureOptions options;

  explicit Trial(std::uint64_t seed) : random(seed) {
    const double scale = 1.0 + options.calibration_share * random.normal();
    view = test::view_of([scale](const Eigen::Vector3d& ray) { return scale * depth_m(ray); },
                         options.matching_px);
    test::add(view, test::matching_error(random, options.matching_px));
  }
  Eigen::Vector2d tapped(const Eigen::Vector2d& aim) {
    return aim + options.pointing_px * Eigen::Vector2d(random.normal(), random.normal());
  }
  SurfacePoint point(const Eigen::Vector2d& aim) {
    return std::get<SurfacePoint>(surface_point(view, tapped(aim), options));
  }
};

const Eigen::Vector2d on_block(80, 62);
const Eigen::Vector2d left(25, 30);
const Eigen::Vector2d right(130, 95);

// The share of trials in which the truth lies within the expanded uncertainty.
double covered(double truth_mm, const std::function<Quantity(Trial&)>& measure) {
  constexpr int trials = 400;
  int within = 0;
  for (int seed = 0; seed < trials; ++seed) {
    Trial trial(mix(2024, seed));
    const Quantity measured = measure(trial);
    within += std::abs(measured.value_mm - truth_mm) <= measured.expanded_mm() ? 1 : 0;
  }
  return static_cast<double>(within) / trials;
}

void expect_covered(double share) {
  EXPECT_GE(share, 0.90);
  EXPECT_LE(share, 0.99);
}

const UncertainView& truth() {
  static const UncertainView view = test::view_of(depth_m);
  return view;
}

TEST(Coverage, OfDistances) {
  expect_covered(covered(1000.0 * point_m(truth(), left).norm(),
                         [](Trial& trial) { return distance_of(trial.point(left), trial.options); }));
}

TEST(Coverage, OfLengths) {
  const double truth_mm = 1000.0 * (point_m(truth(), left) - point_m(truth(), right)).norm();
  expect_covered(covered(truth_mm, [](Trial& trial) {
    return length_between(trial.point(left), trial.point(right), trial.options);
  }));
}

TEST(Coverage, OfLengthsInDepth) {
  const Eigen::Vector2d near(71, 68);
  const double truth_mm = 1000.0 * (point_m(truth(), on_block) - point_m(truth(), near)).norm();
  expect_covered(covered(truth_mm, [near](Trial& trial) {
    return length_between(trial.point(on_block), trial.point(near), trial.options);
  }));
}

TEST(Coverage, OfHeightsAboveARegion) {
  expect_covered(covered(block_mm, [](Trial& trial) {
    const auto plane = std::get<Plane>(plane_in(trial.view, rectangle(45, 30, 70, 60)));
    return height_above(trial.point(on_block), plane, trial.options);
  }));
}

TEST(Coverage, OfHeightsAboveThreePoints) {
  expect_covered(covered(block_mm, [](Trial& trial) {
    const std::array corners{trial.point(left), trial.point(right), trial.point({130, 25})};
    return height_above(trial.point(on_block), std::get<Plane>(plane_through(corners)), trial.options);
  }));
}

TEST(Coverage, OfProfiles) {
  // The block's top is parallel to the surface on which both ends lie.
  const Eigen::Vector3d from = point_m(truth(), {40, 60});
  const Eigen::Vector3d along = (point_m(truth(), {120, 60}) - from).normalized();
  const Eigen::Vector3d top = point_m(truth(), {80, 60}) - from;
  const double truth_mm = 1000.0 * (top - along.dot(top) * along).norm();
  expect_covered(covered(truth_mm, [](Trial& trial) {
    const auto profile = std::get<Profile>(
        profile_along(trial.view, trial.tapped({40, 60}), trial.tapped({120, 60}), trial.options));
    return profile.samples[profile.samples.size() / 2].point->height;
  }));
}

}  // namespace
}  // namespace rva
