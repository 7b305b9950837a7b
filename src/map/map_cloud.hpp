// Views joined into one cloud in the robot's foot frame (algorithm 1 of the thesis, lines 7 and 9 to 11).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core/options.hpp"
#include "map/map_view.hpp"

namespace rva {

/// Options of the joining of all views of a map into one cloud.
struct MapCloudOptions {
  double voxel_mm = 3.0;  ///< edge of the cubes in each of which the map has one point
  double near_m = 0.15;   ///< nearer depth is left out
  double far_m = 2.0;     ///< farther depth is left out

  static void describe(auto&& self, auto&& visit) {
    visit(self.voxel_mm,
          OptionField{"voxel", "mm", 0.5, 1000, "the map has one point in each cube of this size"});
    visit(self.near_m, OptionField{"near", "m", 0, 100, "nearer depth is left out"});
    visit(self.far_m, OptionField{"far", "m", 0.01, 100,
                                  "farther depth is left out: noise grows with the square of distance"});
  }
};

/// Refuses options that are out of range or contradict each other.
/// @throws UsageError when an option is out of range, or near_m is not less than far_m
void check_map_cloud_options(const MapCloudOptions& options);

/// A point of a map's cloud, which stands for the measurements in one voxel.
struct MapPoint {
  Eigen::Vector3f position_m;  ///< in the foot's frame
  Rgb color;                   ///< grey where no view has one
  std::uint16_t views = 0;     ///< number of views with measurements in the point's voxel
};

/// Joins views into one point per voxel with measurements: the mean position over all views, weighted by the
/// inverse of the variance along the line of sight (which grows with the fourth power of depth), and the mean
/// colour. Depth out of range is left out, and so are pixels that supported() rejects, since matches at edges
/// lie between the foreground and the background.
/// @param foot_from_camera the pose of each view
/// @return the points, in an order that depends on the points alone
/// @throws UsageError as check_map_cloud_options(); Interrupted
[[nodiscard]] std::vector<MapPoint> join_views(std::span<const MapView> views,
                                               std::span<const Transform> foot_from_camera,
                                               const MapCloudOptions& options);

/// The pixels of a view that lie on the same surface as at least two thirds (16 of 24) of the pixels around
/// them, within 1 px of disparity.
[[nodiscard]] Mask supported(const DepthView& view);

}  // namespace rva
