// A plane in front of the camera, with its uncertainty.
#pragma once

#include <Eigen/Core>
#include <array>
#include <variant>

#include "depth/image.hpp"
#include "measure/surface_point.hpp"

namespace rva {

/// The plane of all points P with `coefficients_per_m . P = 1`, which does not pass through the camera.
struct Plane {
  Eigen::Vector3d coefficients_per_m = Eigen::Vector3d::Zero();  ///< in the depth camera's frame, 1/m
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();          ///< of the coefficients, 1/m^2
};

/// A plane, or why there is none.
using PlaneOrReason = std::variant<Plane, Unmeasured>;

/// The plane through three points (equation 84).
/// @return collinear where the triangle is thinner than a hundredth of its longest side, or its plane passes
///         through the camera
[[nodiscard]] PlaneOrReason plane_through(const std::array<SurfacePoint, 3>& corners);

/// The plane that most of a region shows, by least squares that a robust start reweights, so that objects on
/// it have no effect as long as they cover less than half of it (equation 83).
/// @param region of the view's size
/// @return outside where the region is empty; missing_depth where less than a third of it, or fewer than
/// twelve
///         pixels, are measured; collinear where they lie in a line
[[nodiscard]] PlaneOrReason plane_in(const UncertainView& view, const Mask& region);

}  // namespace rva
