#include "views/registration_uncertainty.hpp"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

#include "core/random.hpp"
#include "tests/views/box_room.hpp"
#include "views/registration.hpp"

namespace rva {
namespace {

using test::bay;
using test::pose;
using test::Room;
using test::view_of;

constexpr double reach_px = 0.6;

/// The uncertainty of views of one room at their true poses.
RegistrationUncertainty at_truth(const Room& room, const Transform& from, const Transform& to,
                                 double noise_px, std::uint64_t seed) {
  const PlanarPatches initial(view_of(room, from, {noise_px, 0.0, seed}), 4, 8);
  const PlanarPatches final(view_of(room, to, {noise_px, 0.0, seed + 1}), 4, 8);
  return uncertainty(ViewPair(initial, final, 2), {from.inverse() * to, 0.0}, reach_px);
}

/// The view with an error that is the same in squares of the image, as windows of a matcher have it.
DepthView with_errors(DepthView view, int square_px, double deviation_px, std::uint64_t seed) {
  Random random(seed);
  Image<float> squares(view.camera.width / square_px + 1, view.camera.height / square_px + 1);
  for (float& error_px : squares.pixels()) error_px = static_cast<float>(deviation_px * random.normal());
  for (int v = 0; v < view.camera.height; ++v) {
    for (int u = 0; u < view.camera.width; ++u) {
      if (view.disparity_px(u, v) > 0.0F) view.disparity_px(u, v) += squares(u / square_px, v / square_px);
    }
  }
  return view;
}

/// Squared Mahalanobis distances of the errors of registrations: 6 on average if the covariance that each
/// states is right.
struct NormalisedErrors {
  double mean = 0.0;
  double largest = 0.0;
};

NormalisedErrors errors_of_registrations(int square_px, double deviation_px) {
  const Transform from = pose(0.1, 0.0, -4);
  const Transform to = pose(0.0, 0.05, 3);
  const Transform truth = from.inverse() * to;
  const DepthView initial = view_of(bay(), from);
  const DepthView final = view_of(bay(), to);
  constexpr int many = 15;
  NormalisedErrors errors;
  for (std::uint64_t k = 0; k < many; ++k) {
    const Registration found =
        register_views(with_errors(initial, square_px, deviation_px, 2 * k + 1),
                       with_errors(final, square_px, deviation_px, 2 * k + 2), {truth, true});
    const Twist error = log_of(truth * found.initial_from_final.inverse());
    const double square = error.dot(found.covariance.ldlt().solve(error));
    errors.mean += square / many;
    errors.largest = std::max(errors.largest, square);
  }
  return errors;
}

// Variances are stated ten times as large as residuals scatter, for errors that all tiles share. Where there
// are no such errors, squares of normalised errors are therefore a tenth of what they would be.
TEST(RegistrationUncertainty, IsTenTimesThatOfIndependentErrors) {
  for (const double noise_px : {0.05, 0.2}) {
    const double mean = 10.0 * errors_of_registrations(1, noise_px).mean;
    EXPECT_GT(mean, 6.0 / 2.0) << noise_px;
    EXPECT_LT(mean, 6.0 * 2.0) << noise_px;
  }
}

TEST(RegistrationUncertainty, CoversErrorsThatWindowsOfTheMatcherHaveInCommon) {
  for (const int square_px : {8, 16}) {
    const NormalisedErrors errors = errors_of_registrations(square_px, 0.1);
    EXPECT_LT(errors.mean, 6.0) << square_px;
    EXPECT_LT(errors.largest, 12.6) << square_px << ": 95 % of right ones are less";
    EXPECT_GT(errors.mean, 0.5) << square_px << ": too large to be of use";
  }
}

TEST(RegistrationUncertainty, GrowsWithTheNoise) {
  const auto deviations = [](double noise_px, std::uint64_t seed) -> Twist {
    const Transform from = pose(0.1, 0.0, -4);
    return at_truth(bay(), from, pose(0.0, 0.05, 3), noise_px, seed).covariance.diagonal().cwiseSqrt();
  };
  const Twist ratios = deviations(0.4, 1).cwiseQuotient(deviations(0.1, 11));
  EXPECT_GT(ratios.minCoeff(), 4.0 / 2.0) << ratios.transpose();
  EXPECT_LT(ratios.maxCoeff(), 4.0 * 2.0) << ratios.transpose();
}

TEST(RegistrationUncertainty, IsSymmetricAndPositive) {
  const TwistMatrix covariance = at_truth(bay(), pose(0.1, 0.0, -4), pose(0.0, 0.05, 3), 0.1, 1).covariance;
  EXPECT_TRUE(covariance.isApprox(covariance.transpose(), 1e-9));
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<TwistMatrix>(covariance).eigenvalues().minCoeff(), 0.0);
}

TEST(RegistrationUncertainty, OfABareWallIsAMetreAlongIt) {
  const Room wall{{test::box(-9, 9, -9, 9, 1.0, 1.1)}};
  const RegistrationUncertainty found = at_truth(wall, pose(0, 0, 0, 0), pose(0.05, 0, 0, 0), 0.1, 3);
  EXPECT_NEAR(found.distance_m, 1.0, 0.01);
  EXPECT_GE(found.worst_m, 0.99);
  // Turns about the line of sight, shifts to the side, and shifts up or down.
  EXPECT_GE(found.covariance(2, 2), 0.9);
  EXPECT_GE(found.covariance(3, 3), 0.9);
  EXPECT_GE(found.covariance(4, 4), 0.9);
  EXPECT_LT(found.covariance(0, 0), 1e-4);
  EXPECT_LT(found.covariance(1, 1), 1e-4);
  EXPECT_NEAR(std::hypot(found.worst[2], found.worst[3], found.worst[4]), 1.0, 1e-3);
}

TEST(RegistrationUncertainty, OfACorridorIsAMetreAlongIt) {
  const Room corridor{{test::box(-0.5, -0.4, -9, 9, -9, 9), test::box(0.4, 0.5, -9, 9, -9, 9),
                       test::box(-9, 9, -9, 9, 1.2, 1.3)}};
  const RegistrationUncertainty found = at_truth(corridor, pose(0, 0, 0, 0), pose(0, 0.02, 0, 0), 0.1, 5);
  EXPECT_GE(found.worst_m, 0.99);
  EXPECT_GT(std::abs(found.worst[4]), 0.99) << "up and down";
  EXPECT_LT(found.covariance(3, 3), 1e-4) << "the walls constrain the side";
}

TEST(RegistrationUncertainty, OfNothingInViewIsAMetreInAllDirections) {
  const RegistrationUncertainty found = at_truth(Room{}, pose(0, 0, 0), pose(0, 0, 0), 0.1, 7);
  EXPECT_TRUE(found.covariance.isApprox(TwistMatrix::Identity(), 1e-6)) << found.covariance;
}

}  // namespace
}  // namespace rva
