// The point of a surface that a pixel shows, with its uncertainty.
#pragma once

#include <Eigen/Core>
#include <variant>

#include "core/enum_names.hpp"
#include "measure/measure_options.hpp"
#include "measure/uncertain_view.hpp"

namespace rva {

/// Why something cannot be measured.
enum class Unmeasured {
  outside,        ///< the pixel is outside of the depth image
  missing_depth,  ///< depth is missing in more than two thirds of the pixels around
  edge,           ///< the pixels around are of several surfaces, none of which has a third of them
  collinear       ///< the pixels or points do not span a plane
};

/// The names that answers of the API use.
template <>
inline constexpr auto enum_names<Unmeasured> = std::to_array<EnumName<Unmeasured>>({
    {Unmeasured::outside, "outside"},
    {Unmeasured::missing_depth, "no-depth"},
    {Unmeasured::edge, "edge"},
    {Unmeasured::collinear, "collinear"},
});

/// A point of a surface.
struct SurfacePoint {
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  ///< in the depth camera's frame
  /// Covariance of the position. It leaves out the error of the camera's scale, which all points share.
  Eigen::Matrix3d covariance_m2 = Eigen::Matrix3d::Zero();
  /// Whether another surface, or no depth, is within half of a matcher's window: the camera may then show the
  /// surface beside the one that is really there, and the uncertainty does not include this.
  bool near_edge = false;
};

/// A point, or why there is none.
using PointOrReason = std::variant<SurfacePoint, Unmeasured>;

/// How far around a pixel a point is measured.
inline constexpr int point_reach_px = 2;

/// The point at a pixel: a plane fitted to the disparities around it that belong to the surface in its middle
/// (equations 77 to 80). They have at least the uncertainty with which the disparities of 11 x 11 pixels
/// scatter about a plane.
/// @param pixel    of the depth image, may lie between pixels
/// @param reach_px pixels to each side that are used, 1 or more
[[nodiscard]] PointOrReason surface_point(const UncertainView& view, const Eigen::Vector2d& pixel,
                                          const MeasureOptions& options, int reach_px = point_reach_px);

}  // namespace rva
