#include "measure/disparity_plane.hpp"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>

namespace rva {
namespace {

double disparity(const UncertainView& view, const Eigen::Vector2i& pixel) {
  return view.disparity_px(pixel.x(), pixel.y());
}

Eigen::MatrixX3d design(const UncertainView& view, const SurfacePixels& surface,
                        const Eigen::Vector3d& origin) {
  Eigen::MatrixX3d rows(static_cast<Eigen::Index>(surface.pixels.size()), 3);
  for (std::size_t i = 0; i < surface.pixels.size(); ++i) {
    const Eigen::Vector3d ray = view.ray(surface.pixels[i].cast<double>());
    // Per pixel instead of per radian, so that all three columns are of one order.
    rows.row(static_cast<Eigen::Index>(i)) << view.camera.fx * (ray.x() - origin.x()),
        view.camera.fy * (ray.y() - origin.y()), 1.0;
  }
  return rows;
}

// gain * Sigma * gain^T with the correlated errors of the pixels; each has at least this variance.
Eigen::Matrix3d covariance_of(const UncertainView& view, const SurfacePixels& surface,
                              const Eigen::Matrix3Xd& gain, double least_px2) {
  std::vector<Eigen::Vector3d> terms;
  for (std::size_t i = 0; i < surface.pixels.size(); ++i) {
    const Eigen::Vector2i& pixel = surface.pixels[i];
    const double stated_px = view.uncertainty_px(pixel.x(), pixel.y());
    const double sigma_px = std::sqrt(std::max(stated_px * stated_px, least_px2));
    terms.emplace_back(sigma_px * gain.col(static_cast<Eigen::Index>(i)));
  }
  Eigen::Matrix3d sum = Eigen::Matrix3d::Zero();
  for (std::size_t i = 0; i < terms.size(); ++i) {
    Eigen::Vector3d others = 0.5 * terms[i];
    for (std::size_t j = i + 1; j < terms.size(); ++j) {
      const Eigen::Vector2i apart = surface.pixels[i] - surface.pixels[j];
      others += view.correlation(apart.x(), apart.y()) * terms[j];
    }
    sum += terms[i] * others.transpose() + others * terms[i].transpose();
  }
  return sum;
}

/// The least squares of a surface's disparities, with one column a pixel instead of a radian.
struct LeastSquares {
  Eigen::MatrixX3d rows;
  Eigen::VectorXd weights;
  Eigen::VectorXd values;
  Eigen::Matrix3Xd gain;  // coefficients = gain * values
  int rank = 0;
};

LeastSquares least_squares(const UncertainView& view, const SurfacePixels& surface,
                           const Eigen::Vector3d& origin) {
  const auto count = static_cast<Eigen::Index>(surface.pixels.size());
  LeastSquares system{design(view, surface, origin),
                      Eigen::Map<const Eigen::VectorXd>(surface.weights.data(), count),
                      Eigen::VectorXd(count),
                      {},
                      0};
  for (Eigen::Index i = 0; i < count; ++i)
    system.values[i] = disparity(view, surface.pixels[static_cast<std::size_t>(i)]);
  Eigen::CompleteOrthogonalDecomposition<Eigen::Matrix3d> normal;
  normal.setThreshold(1e-9);
  normal.compute(system.rows.transpose() * system.weights.asDiagonal() * system.rows);
  system.gain = normal.pseudoInverse() * system.rows.transpose() * system.weights.asDiagonal();
  system.rank = static_cast<int>(normal.rank());
  return system;
}

double residual_variance(const LeastSquares& system) {
  const double freedom = system.weights.sum() - 3.0;
  if (freedom <= 0.0) return 0.0;
  const Eigen::VectorXd residuals = system.values - system.rows * (system.gain * system.values);
  return (system.weights.array() * residuals.array().square()).sum() / freedom;
}

// What a plane leaves of the variance of correlated errors: 1 where they are independent (equation 78).
double residual_share(const UncertainView& view, const SurfacePixels& surface, const LeastSquares& system) {
  const auto count = static_cast<Eigen::Index>(surface.pixels.size());
  if (count <= 3) return 0.0;
  const Eigen::MatrixXd taken = system.rows * system.gain;
  double trace = 0.0;
  for (Eigen::Index i = 0; i < count; ++i) {
    trace += 1.0 - taken(i, i);
    for (Eigen::Index j = 0; j < i; ++j) {
      const Eigen::Vector2i apart =
          surface.pixels[static_cast<std::size_t>(i)] - surface.pixels[static_cast<std::size_t>(j)];
      trace -= view.correlation(apart.x(), apart.y()) * (taken(i, j) + taken(j, i));
    }
  }
  return trace / static_cast<double>(count - 3);
}

Eigen::Vector3d per_radian(const UncertainView& view) { return {view.camera.fx, view.camera.fy, 1.0}; }

}  // namespace

Eigen::Vector3d disparity_coefficients(const UncertainView& view, const SurfacePixels& surface,
                                       const Eigen::Vector3d& origin) {
  const LeastSquares system = least_squares(view, surface, origin);
  return per_radian(view).cwiseProduct(system.gain * system.values);
}

double scatter_px(const UncertainView& view, const SurfacePixels& surface, const Eigen::Vector3d& origin) {
  const LeastSquares system = least_squares(view, surface, origin);
  const double left = residual_share(view, surface, system);
  return left > 0.0 ? std::sqrt(residual_variance(system) / left) : 0.0;
}

// Equation 77 of docs/math.md.
DisparityPlane fit_disparities(const UncertainView& view, const SurfacePixels& surface,
                               const Eigen::Vector3d& origin, double least_px) {
  const LeastSquares system = least_squares(view, surface, origin);
  const double residual_px2 = residual_variance(system);
  const double least_px2 = std::max(residual_px2, least_px * least_px);
  const Eigen::Vector3d scale = per_radian(view);
  DisparityPlane plane;
  plane.coefficients = scale.cwiseProduct(system.gain * system.values);
  plane.covariance =
      scale.asDiagonal() * covariance_of(view, surface, system.gain, least_px2) * scale.asDiagonal();
  plane.residual_px = std::sqrt(residual_px2);
  plane.rank = system.rank;
  return plane;
}

}  // namespace rva
