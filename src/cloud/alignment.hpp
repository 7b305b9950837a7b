// What registration looks for, and what each sample of a view says about it.
#pragma once

#include <Eigen/Core>
#include <vector>

#include "cloud/planar_patches.hpp"
#include "geometry/transform.hpp"

namespace rva {

struct Alignment {
  Transform initial_from_final = Transform::Identity();
  double offset_px = 0.0;  ///< of the initial camera's disparity against the final one's: it drifts when warm
};

/// How much is known of the offset beforehand, as information: it is about 0.1 px, of residuals of 0.15 px.
inline constexpr double offset_prior = (0.15 * 0.15) / (0.1 * 0.1);

/// (rotation vector, translation, offset) in rad, m, px: the transform becomes
/// exp(rotation, translation) * initial_from_final.
using AlignmentStep = Eigen::Matrix<double, 7, 1>;
using AlignmentInformation = Eigen::Matrix<double, 7, 7>;

[[nodiscard]] Alignment moved(const Alignment& alignment, const AlignmentStep& step);

/// A place on a surface that a view saw, in its camera's frame.
struct SurfaceSample {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();
  /// By a point's position: its disparity less what the surface has at its pixel. px / m
  Eigen::Vector3d gradient = Eigen::Vector3d::Zero();
};

/// The centres of patches, of every so many rows and columns.
[[nodiscard]] std::vector<SurfaceSample> samples_of(const PlanarPatches& patches, int every);

/// Residuals are in disparity, where noise is even: what the moved point should have, less what the plane has
/// where it projects to. Above 0, the point lies in front of the surface.
struct AlignmentResidual {
  double px = 0.0;
  AlignmentStep by_step;         ///< with the slope of the surface that the point falls onto
  AlignmentStep by_step_of_own;  ///< the same with the slope of the surface that the point is on
};

/// @return false where the point falls onto no plane
[[nodiscard]] bool final_on_initial(const SurfaceSample& final_point, const PlanarPatches& initial,
                                    const Alignment& alignment, AlignmentResidual& residual);
[[nodiscard]] bool initial_on_final(const SurfaceSample& initial_point, const PlanarPatches& final,
                                    const Alignment& alignment, const Transform& final_from_initial,
                                    AlignmentResidual& residual);

/// Tukey's biweight: 1 for a residual of 0, 0 from `reach_px` on.
[[nodiscard]] double weight_of(double residual_px, double reach_px);

}  // namespace rva
