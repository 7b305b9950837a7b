// Change between clouds as in the thesis (chapter 3.3, figure 3.18), with the library used there.
#pragma once

#include <cstddef>
#include <vector>

#include "detect/thesis/point_cloud.hpp"
#include "geometry/transform.hpp"

namespace rva {

/// Points of the final cloud in cells that contain no point of the initial one (PCL's
/// OctreePointCloudChangeDetector).
/// @param final_from_initial aligns the initial cloud with the final one
/// @param cell_m             edge of a cell, metres; above 0
/// @return indices into `final`, ascending
[[nodiscard]] std::vector<std::size_t> points_in_new_cells(const PointCloud& initial, const PointCloud& final,
                                                           const Transform& final_from_initial,
                                                           double cell_m);

}  // namespace rva
