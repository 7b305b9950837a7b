// The parameters that registration estimates, and the residual of each sample of a view.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "geometry/transform.hpp"
#include "views/planar_patches.hpp"

namespace rva {

/// The current estimate of a registration.
struct Alignment {
  Transform initial_from_final = Transform::Identity();  ///< pose of the final camera
  double offset_px = 0.0;  ///< disparity of the initial camera minus that of the final one: thermal drift
};

/// Prior information on the offset, which is about 0.1 px, for residuals of 0.15 px.
inline constexpr double offset_prior = (0.15 * 0.15) / (0.1 * 0.1);

/// A twist in the initial camera's frame (rad, m), then the offset (px). The transform becomes
/// exp_of(twist) * initial_from_final (geometry/rigid_motion.hpp); the offset is added.
using AlignmentStep = Eigen::Matrix<double, 7, 1>;
/// The information matrix of an AlignmentStep, in the order of its elements.
using AlignmentInformation = Eigen::Matrix<double, 7, 7>;

/// The alignment after a step.
[[nodiscard]] Alignment moved(const Alignment& alignment, const AlignmentStep& step);

/// A point on a surface in a view, in the camera's frame.
struct SurfaceSample {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< on the surface
  /// Derivative, by a point's position, of its disparity minus that of the surface at its pixel, px / m.
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
};

/// The centres of the patches of every `every`-th row and column.
[[nodiscard]] std::vector<SurfaceSample> samples_of(const PlanarPatches& patches, int every);

/// A residual is in disparity, where noise is uniform: the disparity of the moved point minus that of the
/// plane at the pixel to which it projects. Positive if the point lies in front of the surface.
struct AlignmentResidual {
  double px = 0.0;               ///< disparity of the point minus that of the plane
  AlignmentStep by_step;         ///< derivative, with the slope of the surface onto which the point falls
  AlignmentStep by_step_of_own;  ///< derivative, with the slope of the surface on which the point lies
};

/// Compares a point of the final view with the planes of the initial one.
/// @return false if the point falls onto no plane
[[nodiscard]] bool final_on_initial(const SurfaceSample& final_point, const PlanarPatches& initial,
                                    const Alignment& alignment, AlignmentResidual& residual);
/// Compares a point of the initial view with the planes of the final one.
/// @return false if the point falls onto no plane
[[nodiscard]] bool initial_on_final(const SurfaceSample& initial_point, const PlanarPatches& final,
                                    const Alignment& alignment, const Transform& final_from_initial,
                                    AlignmentResidual& residual);

/// Tukey's biweight: 1 for a residual of 0, and 0 from `reach_px` upwards.
[[nodiscard]] double weight_of(double residual_px, double reach_px);

}  // namespace rva
