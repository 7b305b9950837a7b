// Views joined into one cloud in the robot's foot frame (algorithm 1 of the thesis, lines 7 and 9 to 11).
#pragma once

#include <Eigen/Core>
#include <cstdint>
#include <span>
#include <vector>

#include "core/options.hpp"
#include "map/map_view.hpp"

namespace rva {

struct MapCloudOptions {
  double voxel_mm = 3.0;
  double near_m = 0.15;
  double far_m = 2.0;

  static void describe(auto&& self, auto&& visit) {
    visit(self.voxel_mm,
          OptionField{"voxel", "mm", 0.5, 1000, "the map has one point in each cube of this size"});
    visit(self.near_m, OptionField{"near", "m", 0, 100, "nearer depth is left out"});
    visit(self.far_m, OptionField{"far", "m", 0.01, 100,
                                  "farther depth is left out: noise grows with the square of distance"});
  }
};

/// @throws UsageError when an option is out of range, or nothing lies between near_m and far_m
void check_map_cloud_options(const MapCloudOptions& options);

struct MapPoint {
  Eigen::Vector3f position_m;  ///< in the foot's frame
  Rgb color;                   ///< grey where no view has one
  std::uint16_t views = 0;     ///< that have measured something in the point's cube
};

/// One point for each cube that something was measured in: the mean of what all views measured there,
/// weighted by the inverse of its variance along the line of sight (which grows with the fourth power of
/// depth), and the mean colour. Left out of each view: depth out of range, and what little around it is on
/// the same surface, since matches at edges lie between what is before and what is behind.
/// @param foot_from_camera of each view
/// @return in an order that depends on the points alone
/// @throws UsageError as check_map_cloud_options(); Interrupted
[[nodiscard]] std::vector<MapPoint> join_views(std::span<const MapView> views,
                                               std::span<const Transform> foot_from_camera,
                                               const MapCloudOptions& options);

/// Pixels of a view that are on a surface with at least two thirds of the pixels around them.
[[nodiscard]] Mask supported(const DepthView& view);

}  // namespace rva
