// The residual of registration and its derivatives, for one point or for many at once: double precision for
// one, and single precision in blocks for the sums over a view (section 6 of docs/math.md).
//
// `Numbers` is an Eigen::Array of fixed size with one entry for each point.
#pragma once

#include <Eigen/Core>
#include <array>

#include "geometry/transform.hpp"
#include "views/planar_patches.hpp"

namespace rva {

/// Vectors of many points: an array for each coordinate.
template <typename Numbers>
using Vectors = std::array<Numbers, 3>;

/// A rotation matrix with the numbers of these vectors.
template <typename Numbers>
using RotationOf = Eigen::Matrix<typename Numbers::Scalar, 3, 3>;

/// The vectors, rotated.
template <typename Numbers>
[[nodiscard]] Vectors<Numbers> turned(const RotationOf<Numbers>& by, const Vectors<Numbers>& v) {
  return {by(0, 0) * v[0] + by(0, 1) * v[1] + by(0, 2) * v[2],
          by(1, 0) * v[0] + by(1, 1) * v[1] + by(1, 2) * v[2],
          by(2, 0) * v[0] + by(2, 1) * v[1] + by(2, 2) * v[2]};
}

/// The points, transformed.
template <typename Numbers>
[[nodiscard]] Vectors<Numbers> moved(const Transform& by, const Vectors<Numbers>& v) {
  using Scalar = typename Numbers::Scalar;
  const Eigen::Matrix<Scalar, 3, 1> shift = by.translation().cast<Scalar>();
  Vectors<Numbers> result = turned<Numbers>(by.linear().cast<Scalar>(), v);
  for (std::size_t axis = 0; axis < 3; ++axis) result.at(axis) += shift[static_cast<Eigen::Index>(axis)];
  return result;
}

/// Derivative of a point's disparity minus that of a plane at the point's pixel, by the point's position, px
/// / m (equation 33). @param along_u, along_v slopes of the plane times the focal lengths
template <typename Numbers>
[[nodiscard]] Vectors<Numbers> gradient_at(const Vectors<Numbers>& points, const Numbers& by_z,
                                           const Numbers& along_u, const Numbers& along_v,
                                           typename Numbers::Scalar focal_baseline_m_px) {
  return {-along_u * by_z, -along_v * by_z,
          (along_u * points[0] + along_v * points[1] - focal_baseline_m_px) * by_z.square()};
}

/// Points compared with the planes of a view at the pixels to which they project.
template <typename Numbers>
struct PointsOnPlanes {
  Numbers compared = Numbers::Zero();  ///< 1 where there is a plane, else 0
  Numbers px = Numbers::Zero();        ///< disparity of the points minus that of the planes
  Vectors<Numbers> gradient;           ///< derivative of px by position, px / m
};

/// Equation 32. @param points in the frame of the camera of `onto`; @param count number of valid points
template <typename Numbers>
[[nodiscard]] PointsOnPlanes<Numbers> on_planes(const Vectors<Numbers>& points, Eigen::Index count,
                                                const PlanarPatches& onto) {
  using Scalar = typename Numbers::Scalar;
  constexpr auto nearest_m = static_cast<Scalar>(0.05);
  const Intrinsics& camera = onto.camera();
  const auto focal_baseline_m_px = static_cast<Scalar>(onto.stereo().focal_baseline_m_px);
  const auto fx = static_cast<Scalar>(camera.fx);
  const auto fy = static_cast<Scalar>(camera.fy);
  const Numbers by_z = points[2].max(nearest_m).inverse();
  const Numbers u = fx * points[0] * by_z + static_cast<Scalar>(camera.cx);
  const Numbers v = fy * points[1] * by_z + static_cast<Scalar>(camera.cy);
  Numbers plane_px = Numbers::Zero();
  Numbers along_u = Numbers::Zero();
  Numbers along_v = Numbers::Zero();
  PointsOnPlanes<Numbers> result;
  for (Eigen::Index i = 0; i < count; ++i) {
    if (points[2][i] < nearest_m) continue;
    const PlanarPatch* const patch = onto.find(u[i], v[i]);
    if (patch == nullptr) continue;
    result.compared[i] = 1;
    plane_px[i] = static_cast<Scalar>(onto.disparity_px(*patch, u[i], v[i]));
    along_u[i] = static_cast<Scalar>(patch->slope_u) * fx;
    along_v[i] = static_cast<Scalar>(patch->slope_v) * fy;
  }
  result.px = focal_baseline_m_px * by_z - plane_px;
  result.gradient = gradient_at(points, by_z, along_u, along_v, focal_baseline_m_px);
  return result;
}

/// Derivatives by the seven numbers of an AlignmentStep (equation 35).
template <typename Numbers>
using BySteps = std::array<Numbers, 7>;

/// @param gradient  derivative of the residual by position
/// @param by_offset derivative of the residual by the offset
template <typename Numbers>
[[nodiscard]] BySteps<Numbers> by_step(const Vectors<Numbers>& points, const Vectors<Numbers>& gradient,
                                       typename Numbers::Scalar by_offset) {
  return {points[1] * gradient[2] - points[2] * gradient[1],
          points[2] * gradient[0] - points[0] * gradient[2],
          points[0] * gradient[1] - points[1] * gradient[0],
          gradient[0],
          gradient[1],
          gradient[2],
          Numbers::Constant(by_offset)};
}

/// Residuals and their derivatives by a step.
template <typename Numbers>
struct SurfaceResiduals {
  Numbers compared;          ///< 1 where a point falls onto a plane, else 0
  Numbers px;                ///< positive where a point lies in front of the surface
  BySteps<Numbers> by_step;  ///< derivatives of px by the numbers of the step
};

/// Points of the final view compared with the planes of the initial one (equation 35).
template <typename Numbers>
[[nodiscard]] SurfaceResiduals<Numbers> final_on_initial(const Vectors<Numbers>& final_points,
                                                         Eigen::Index count, const PlanarPatches& initial,
                                                         const Transform& initial_from_final,
                                                         double offset_px) {
  using Scalar = typename Numbers::Scalar;
  const Vectors<Numbers> points = moved(initial_from_final, final_points);
  const PointsOnPlanes<Numbers> onto = on_planes(points, count, initial);
  return {onto.compared, onto.px + static_cast<Scalar>(offset_px), by_step(points, onto.gradient, Scalar{1})};
}

/// Points of the initial view compared with the planes of the final one. A step moves the frame of the final
/// view; relative to it, an initial point moves the opposite way (equation 36).
template <typename Numbers>
[[nodiscard]] SurfaceResiduals<Numbers> initial_on_final(const Vectors<Numbers>& initial_points,
                                                         Eigen::Index count, const PlanarPatches& final,
                                                         const Transform& initial_from_final,
                                                         const Transform& final_from_initial,
                                                         double offset_px) {
  using Scalar = typename Numbers::Scalar;
  const PointsOnPlanes<Numbers> onto = on_planes(moved(final_from_initial, initial_points), count, final);
  const RotationOf<Numbers> back = -initial_from_final.linear().cast<Scalar>();
  return {onto.compared, onto.px - static_cast<Scalar>(offset_px),
          by_step(initial_points, turned<Numbers>(back, onto.gradient), Scalar{-1})};
}

/// Tukey's biweight: 1 for a residual of 0, and 0 from `reach_px` upwards.
template <typename Numbers>
[[nodiscard]] Numbers biweight(const Numbers& residuals_px, typename Numbers::Scalar reach_px) {
  return (typename Numbers::Scalar{1} - (residuals_px / reach_px).square())
      .max(typename Numbers::Scalar{0})
      .square();
}

}  // namespace rva
