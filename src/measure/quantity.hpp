// Lengths with their uncertainty.
#pragma once

#include "measure/plane.hpp"
#include "measure/surface_point.hpp"

namespace rva {

/// The coverage factor of expanded uncertainties: about 95 % of measurements err by less.
inline constexpr double coverage_factor = 2.0;

/// A length with its standard uncertainty.
struct Quantity {
  double value_mm = 0.0;        ///< as measured
  double uncertainty_mm = 0.0;  ///< one standard deviation, of all errors together

  /// The uncertainty as people are shown it.
  [[nodiscard]] double expanded_mm() const { return coverage_factor * uncertainty_mm; }
};

/// The distance of a point from the centre of the imager, along the line of sight (equation 81).
[[nodiscard]] Quantity distance_of(const SurfacePoint& point, const MeasureOptions& options);

/// The distance between two points (equation 82). Of points that coincide, 0 with the uncertainty of the
/// longest direction.
[[nodiscard]] Quantity length_between(const SurfacePoint& a, const SurfacePoint& b,
                                      const MeasureOptions& options);

/// The distance of a point from a plane, positive on the camera's side (equation 85).
[[nodiscard]] Quantity height_above(const SurfacePoint& point, const Plane& plane,
                                    const MeasureOptions& options);

}  // namespace rva
