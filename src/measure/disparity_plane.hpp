// A plane fitted to disparities, which are linear in the rays of a plane's pixels.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "measure/uncertain_view.hpp"

namespace rva {

/// Pixels of a view that show one surface.
struct SurfacePixels {
  std::vector<Eigen::Vector2i> pixels;  ///< each seen by the view
  std::vector<double> weights;          ///< one for each, 0 or more
};

/// Disparity as a linear function of a ray (x, y, 1): `coefficients` times the ray less that of the origin.
struct DisparityPlane {
  Eigen::Vector3d coefficients = Eigen::Vector3d::Zero();  ///< along x, along y, and at the origin, px
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();    ///< of the coefficients
  double residual_px = 0.0;  ///< standard deviation of the disparities about the plane
  int rank = 0;              ///< 3 where the pixels span a plane; less where they are few or in a line
};

/// Weighted least squares, without the covariance and the residual, which take longer.
/// @param origin as of fit_disparities()
[[nodiscard]] Eigen::Vector3d disparity_coefficients(const UncertainView& view, const SurfacePixels& surface,
                                                     const Eigen::Vector3d& origin);

/// Standard deviation of the errors of a surface's disparities, px, from their residuals about the plane that
/// fits them best, which takes up part of errors that neighbours share (equation 78); 0 for three pixels or
/// fewer. All weights are taken to be 1.
[[nodiscard]] double scatter_px(const UncertainView& view, const SurfacePixels& surface,
                                const Eigen::Vector3d& origin);

/// Weighted least squares with the covariance of correlated errors (equation 77).
/// @param origin   a ray (x, y, 1); the third coefficient is the disparity there
/// @param least_px each disparity is taken to have this standard uncertainty at least, and that of the
///                 residuals
[[nodiscard]] DisparityPlane fit_disparities(const UncertainView& view, const SurfacePixels& surface,
                                             const Eigen::Vector3d& origin, double least_px = 0.0);

}  // namespace rva
