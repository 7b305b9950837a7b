#include "measure/plane.hpp"

#include <Eigen/LU>
#include <algorithm>
#include <cassert>
#include <cmath>
#include <iterator>
#include <limits>
#include <vector>

#include "core/quantile.hpp"
#include "core/random.hpp"
#include "measure/disparity_plane.hpp"

namespace rva {
namespace {

/// The covariance takes the square of the number of pixels, and more of them improve a plane little. A region
/// is thinned to at most four times as many.
constexpr std::size_t most_pixels = 800;
constexpr std::size_t least_pixels = 12;
constexpr int rounds = 15;
/// Tukey's constant (equation 12), and the least deviation that residuals are weighted by.
constexpr double tukey = 4.685;
constexpr double least_deviation_px = 0.02;

struct Region {
  std::vector<Eigen::Vector2i> seen;
  std::size_t pixels = 0;
};

Region pixels_of(const UncertainView& view, const Mask& mask) {
  Region region;
  for (int v = 0; v < mask.height(); ++v) {
    for (int u = 0; u < mask.width(); ++u) {
      if (mask(u, v) == 0) continue;
      ++region.pixels;
      if (view.seen(u, v)) region.seen.emplace_back(u, v);
    }
  }
  return region;
}

// Those of a coarser grid.
std::vector<Eigen::Vector2i> thinned(const std::vector<Eigen::Vector2i>& pixels) {
  const auto step = std::max(
      1, static_cast<int>(std::sqrt(static_cast<double>(pixels.size()) / static_cast<double>(most_pixels))));
  std::vector<Eigen::Vector2i> few;
  std::ranges::copy_if(pixels, std::back_inserter(few), [step](const Eigen::Vector2i& pixel) {
    return pixel.x() % step == 0 && pixel.y() % step == 0;
  });
  return few;
}

Eigen::VectorXd residuals(const UncertainView& view, const std::vector<Eigen::Vector2i>& pixels,
                          const Eigen::Vector3d& coefficients, const Eigen::Vector3d& origin) {
  Eigen::VectorXd all(static_cast<Eigen::Index>(pixels.size()));
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    Eigen::Vector3d ray = view.ray(pixels[i].cast<double>()) - origin;
    ray.z() = 1.0;
    all[static_cast<Eigen::Index>(i)] =
        view.disparity_px(pixels[i].x(), pixels[i].y()) - coefficients.dot(ray);
  }
  return all;
}

std::vector<double> tukey_weights(const Eigen::VectorXd& residuals_px) {
  std::vector<double> sizes;
  for (const double residual : residuals_px) sizes.push_back(std::abs(residual));
  const double reach_px = tukey * std::max(robust_deviation(sizes), least_deviation_px);
  std::vector<double> weights;
  for (const double residual : residuals_px) {
    const double share = residual / reach_px;
    weights.push_back(std::abs(share) < 1.0 ? std::pow(1.0 - share * share, 2) : 0.0);
  }
  return weights;
}

double median_size(const Eigen::VectorXd& residuals_px) {
  std::vector<double> sizes;
  for (const double residual : residuals_px) sizes.push_back(std::abs(residual));
  return quantile(sizes, 0.5);
}

// The plane through three of the pixels from which half of all differ least (least median of squares,
// Rousseeuw 1984): weights alone do not leave a plane that lies between a surface and what is on it.
Eigen::Vector3d first_plane(const UncertainView& view, const std::vector<Eigen::Vector2i>& pixels,
                            const Eigen::Vector3d& origin) {
  constexpr int tries = 200;
  Random random(1);  // the same for all regions, so that a measurement can be repeated
  const auto any = [&] {
    return pixels[static_cast<std::size_t>(random.uniform() * static_cast<double>(pixels.size()))];
  };
  Eigen::Vector3d best = Eigen::Vector3d::Zero();
  double least_px = std::numeric_limits<double>::infinity();
  for (int i = 0; i < tries; ++i) {
    const SurfacePixels three{{any(), any(), any()}, {1.0, 1.0, 1.0}};
    const Eigen::Vector3d through = disparity_coefficients(view, three, origin);
    const double size_px = median_size(residuals(view, pixels, through, origin));
    if (size_px >= least_px) continue;
    least_px = size_px;
    best = through;
  }
  return best;
}

DisparityPlane robust_fit(const UncertainView& view, const std::vector<Eigen::Vector2i>& pixels,
                          const Eigen::Vector3d& origin) {
  SurfacePixels surface{pixels, {}};
  Eigen::Vector3d coefficients = first_plane(view, pixels, origin);
  for (int round = 0; round < rounds; ++round) {
    surface.weights = tukey_weights(residuals(view, pixels, coefficients, origin));
    const Eigen::Vector3d before = coefficients;
    coefficients = disparity_coefficients(view, surface, origin);
    if ((coefficients - before).norm() < 1e-9) break;
  }
  return fit_disparities(view, surface, origin);
}

}  // namespace

PlaneOrReason plane_through(const std::array<SurfacePoint, 3>& corners) {
  Eigen::Matrix3d rows;
  for (int i = 0; i < 3; ++i) rows.row(i) = corners[static_cast<std::size_t>(i)].position_m.transpose();
  const Eigen::Vector3d side = rows.row(1) - rows.row(0);
  const Eigen::Vector3d other = rows.row(2) - rows.row(0);
  const double longest_m = std::max({side.norm(), other.norm(), (side - other).norm()});
  constexpr double thinnest = 0.01;
  const double farthest_m = rows.rowwise().norm().maxCoeff();
  const bool thin = side.cross(other).norm() <= thinnest * longest_m * longest_m;
  // The volume with the camera's centre vanishes where the plane passes through it.
  if (thin || std::abs(rows.determinant()) <= thinnest * side.cross(other).norm() * farthest_m)
    return Unmeasured::collinear;
  const Eigen::Matrix3d inverse = rows.inverse();
  Plane plane{inverse * Eigen::Vector3d::Ones(), {}};
  Eigen::Vector3d variances;
  for (int i = 0; i < 3; ++i)
    variances[i] = plane.coefficients_per_m.dot(corners[static_cast<std::size_t>(i)].covariance_m2 *
                                                plane.coefficients_per_m);
  plane.covariance = inverse * variances.asDiagonal() * inverse.transpose();
  return plane;
}

PlaneOrReason plane_in(const UncertainView& view, const Mask& region) {
  assert(region.width() == view.camera.width && region.height() == view.camera.height);
  const Region all = pixels_of(view, region);
  if (all.pixels == 0) return Unmeasured::outside;
  if (3 * all.seen.size() < all.pixels || all.seen.size() < least_pixels) return Unmeasured::missing_depth;
  const std::vector<Eigen::Vector2i> pixels = thinned(all.seen);
  const Eigen::Vector3d origin = view.ray(pixels[pixels.size() / 2].cast<double>());
  const DisparityPlane fit = robust_fit(view, pixels, origin);
  if (fit.rank < 3) return Unmeasured::collinear;
  // From the ray less the origin's to the ray itself, and from disparity to 1/m.
  Eigen::Matrix3d from_origin = Eigen::Matrix3d::Identity();
  from_origin(2, 0) = -origin.x();
  from_origin(2, 1) = -origin.y();
  from_origin /= view.stereo.focal_baseline_m_px;
  return Plane{from_origin * fit.coefficients, from_origin * fit.covariance * from_origin.transpose()};
}

}  // namespace rva
