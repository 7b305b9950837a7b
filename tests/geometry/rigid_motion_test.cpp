#include "geometry/rigid_motion.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>
#include <unsupported/Eigen/MatrixFunctions>

#include "core/random.hpp"

namespace rva {
namespace {

constexpr int trials = 200;
constexpr double tolerance = 1e-10;

/// Twists with rotations of up to `most_rad`.
class Twists {
 public:
  Twist draw(double most_rad) {
    Twist twist;
    for (Eigen::Index i = 0; i < 6; ++i) twist[i] = random_.normal();
    twist.head<3>() *= most_rad * random_.uniform() / twist.head<3>().norm();
    return twist;
  }

 private:
  Random random_{1};
};

Eigen::Matrix4d as_matrix(const Twist& twist) {
  Eigen::Matrix4d matrix = Eigen::Matrix4d::Zero();
  matrix << 0, -twist[2], twist[1], twist[3],  //
      twist[2], 0, -twist[0], twist[4],        //
      -twist[1], twist[0], 0, twist[5],        //
      0, 0, 0, 0;
  return matrix;
}

TEST(RigidMotion, ExpIsTheMatrixExponential) {
  Twists twists;
  for (int i = 0; i < trials; ++i) {
    const Twist twist = twists.draw(3.0);
    const Eigen::Matrix4d wanted = as_matrix(twist).exp();
    EXPECT_TRUE(exp_of(twist).matrix().isApprox(wanted, tolerance)) << twist.transpose();
  }
}

TEST(RigidMotion, LogUndoesExp) {
  Twists twists;
  for (const double most_rad : {1e-12, 1e-7, 1.0001e-4, 1e-3, 1.0, 3.1}) {
    for (int i = 0; i < trials; ++i) {
      const Twist twist = twists.draw(most_rad);
      EXPECT_LT((log_of(exp_of(twist)) - twist).norm(), 1e-8) << twist.transpose();
    }
  }
}

TEST(RigidMotion, ExpUndoesLogAlsoOfHalfTurns) {
  Twists twists;
  for (int i = 0; i < trials; ++i) {
    Twist twist = twists.draw(1.0);
    twist.head<3>() *= std::numbers::pi / twist.head<3>().norm();
    const Transform motion = exp_of(twist);
    EXPECT_TRUE(exp_of(log_of(motion)).isApprox(motion, 1e-7)) << twist.transpose();
  }
}

TEST(RigidMotion, NothingIsTheIdentity) {
  EXPECT_EQ(exp_of(Twist::Zero()).matrix(), Eigen::Matrix4d::Identity());
  EXPECT_EQ(log_of(Transform::Identity()), Twist::Zero());
}

TEST(RigidMotion, OppositeTwistIsTheInverse) {
  Twists twists;
  for (int i = 0; i < trials; ++i) {
    const Twist twist = twists.draw(3.0);
    EXPECT_TRUE(exp_of(-twist).isApprox(exp_of(twist).inverse(), tolerance));
  }
}

TEST(RigidMotion, TwistsAlongOneAxisAdd) {
  Twists twists;
  for (int i = 0; i < trials; ++i) {
    const Twist twist = twists.draw(3.0);
    EXPECT_TRUE((exp_of(0.3 * twist) * exp_of(0.5 * twist)).isApprox(exp_of(0.8 * twist), tolerance));
  }
}

TEST(RigidMotion, SmallTwistsAddToFirstOrder) {
  Twists twists;
  for (int i = 0; i < trials; ++i) {
    const Twist first = 1e-5 * twists.draw(3.0);
    const Twist second = 1e-5 * twists.draw(3.0);
    EXPECT_LT((log_of(exp_of(first) * exp_of(second)) - (first + second)).norm(), 1e-8);
  }
}

TEST(RigidMotion, AdjointTakesATwistToAnotherFrame) {
  Twists twists;
  for (int i = 0; i < trials; ++i) {
    const Transform a_from_b = exp_of(twists.draw(3.0));
    const Twist in_b = twists.draw(1.0);
    const Transform in_a = a_from_b * exp_of(in_b) * a_from_b.inverse();
    EXPECT_TRUE(exp_of(adjoint(a_from_b) * in_b).isApprox(in_a, tolerance));
  }
}

TEST(RigidMotion, AdjointsMultiplyAsTheirTransforms) {
  Twists twists;
  for (int i = 0; i < trials; ++i) {
    const Transform a_from_b = exp_of(twists.draw(3.0));
    const Transform b_from_c = exp_of(twists.draw(3.0));
    EXPECT_TRUE(adjoint(a_from_b * b_from_c).isApprox(adjoint(a_from_b) * adjoint(b_from_c), tolerance));
    EXPECT_TRUE(adjoint(a_from_b.inverse()).isApprox(adjoint(a_from_b).inverse(), tolerance));
  }
}

}  // namespace
}  // namespace rva
