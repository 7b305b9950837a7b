#include "geometry/transform.hpp"

#include <Eigen/SVD>

#include "core/error.hpp"

namespace rva {
namespace {

using RowMajor4 = Eigen::Matrix<double, 4, 4, Eigen::RowMajor>;
constexpr double rotation_tolerance = 1e-3;

}  // namespace

std::array<double, 16> to_row_major(const Transform& a_from_b) {
  std::array<double, 16> numbers{};
  Eigen::Map<RowMajor4>(numbers.data()) = a_from_b.matrix();
  return numbers;
}

Transform from_row_major(std::span<const double, 16> numbers) {
  const RowMajor4 matrix = Eigen::Map<const RowMajor4>(numbers.data());
  const Eigen::Matrix3d upper_left = matrix.topLeftCorner<3, 3>();
  const bool orthonormal =
      matrix.allFinite() && upper_left.determinant() > 0.0 &&
      (upper_left * upper_left.transpose()).isApprox(Eigen::Matrix3d::Identity(), rotation_tolerance);
  if (!orthonormal || !matrix.row(3).isApprox(Eigen::RowVector4d(0, 0, 0, 1), rotation_tolerance)) {
    throw Error("transform", "the 16 numbers are not a rotation and a translation",
                "give them row by row, the last row 0 0 0 1");
  }
  // The nearest rotation in the least-squares sense (orthogonal Procrustes).
  const Eigen::JacobiSVD<Eigen::Matrix3d> svd(upper_left, Eigen::ComputeFullU | Eigen::ComputeFullV);
  Transform a_from_b = Transform::Identity();
  a_from_b.linear() = svd.matrixU() * svd.matrixV().transpose();
  a_from_b.translation() = matrix.topRightCorner<3, 1>();
  return a_from_b;
}

}  // namespace rva
