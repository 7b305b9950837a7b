#include "geometry/rigid_motion.hpp"

#include <Eigen/Geometry>
#include <cmath>

#include "core/units.hpp"

namespace rva {
namespace {

// Below this angle, the leading terms of the series are exact to double precision, and the closed forms are
// not.
constexpr double small_rad = 1e-4;

Eigen::Matrix3d cross_matrix(const Eigen::Vector3d& v) {
  Eigen::Matrix3d matrix;
  matrix << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return matrix;
}

// The mean of the rotations on the way, by which the translation of a twist is multiplied (equation 174).
Eigen::Matrix3d mean_rotation(const Eigen::Vector3d& rotation) {
  const double angle2 = rotation.squaredNorm();
  const double angle = std::sqrt(angle2);
  const bool small = angle < small_rad;
  const double first = small ? 0.5 - angle2 / 24.0 : (1.0 - std::cos(angle)) / angle2;
  const double second = small ? 1.0 / 6.0 - angle2 / 120.0 : (angle - std::sin(angle)) / (angle2 * angle);
  const Eigen::Matrix3d cross = cross_matrix(rotation);
  return Eigen::Matrix3d::Identity() + first * cross + second * cross * cross;
}

Eigen::Matrix3d rotation_of(const Eigen::Vector3d& rotation) {
  const double angle = rotation.norm();
  if (angle == 0.0) return Eigen::Matrix3d::Identity();
  return Eigen::AngleAxisd(angle, rotation / angle).toRotationMatrix();
}

}  // namespace

Transform exp_of(const Twist& twist) {
  const Eigen::Vector3d rotation = twist.head<3>();
  Transform motion = Transform::Identity();
  motion.linear() = rotation_of(rotation);
  motion.translation() = mean_rotation(rotation) * twist.tail<3>();
  return motion;
}

Twist log_of(const Transform& motion) {
  const Eigen::AngleAxisd turn(motion.linear());
  const Eigen::Vector3d rotation = turn.angle() * turn.axis();
  Twist twist;
  twist << rotation, mean_rotation(rotation).inverse() * motion.translation();
  return twist;
}

double angle_deg_of(const Transform& motion) { return degrees(Eigen::AngleAxisd(motion.linear()).angle()); }

TwistMatrix adjoint(const Transform& a_from_b) {
  const Eigen::Matrix3d turn = a_from_b.linear();
  TwistMatrix result = TwistMatrix::Zero();
  result.topLeftCorner<3, 3>() = turn;
  result.bottomRightCorner<3, 3>() = turn;
  result.bottomLeftCorner<3, 3>() = cross_matrix(a_from_b.translation()) * turn;
  return result;
}

}  // namespace rva
