// Measuring in the pictures of a review, and in the map, by the depth of the captures that they show.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>

#include "geometry/pan_tilt.hpp"
#include "inspect/inspection.hpp"
#include "inspect/inspection_folder.hpp"
#include "measure/measured_picture.hpp"
#include "measure/quantity.hpp"

namespace rva {

/// The pictures of a view before or after the work, with the depth of the first capture of that side. Both
/// have the pixels of the final depth image (ReviewPictures).
/// @throws Error when there is no such view, the round that was compared is not known, or a file cannot be
/// read
[[nodiscard]] MeasuredPicture measured_review(const InspectionFolder& folder, const Inspection& inspection,
                                              const RecordedComparison& comparison, int view, Side side,
                                              const MeasureOptions& options);

/// A point of the map, as the view that shows it best measures it.
struct MeasuredMapPoint {
  SurfacePoint point;  ///< in the frame of the robot's foot
  Quantity distance;   ///< from the camera of that view
};

/// Two points of the map, each empty where no view measures it, and the length between them.
struct MapMeasurement {
  std::array<std::optional<MeasuredMapPoint>, 2> points;
  std::optional<Quantity> length;  ///< empty unless both are measured
};

/// Measures the surface at two points of the map of a comparison, which may be an earlier one: in one view,
/// if one shows both, otherwise each in the view that is nearest to it, with the error of the robot's rest at
/// each.
/// @param points_m of the map, in the frame of the robot's foot
/// @param chain    the robot's geometry, from which the poses of captures that state none are taken
/// @throws Error when the round that was compared is not known, or a capture cannot be read
[[nodiscard]] MapMeasurement measure_in_map(const InspectionFolder& folder, const Inspection& inspection,
                                            const RecordedComparison& comparison, const PanTiltChain& chain,
                                            const std::array<Eigen::Vector3d, 2>& points_m,
                                            const MeasureOptions& options);

}  // namespace rva
