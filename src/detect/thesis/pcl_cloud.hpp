// Conversion of point clouds for PCL.
#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include "detect/thesis/point_cloud.hpp"

namespace rva {

/// A cloud of points in PCL's own form.
using PclCloud = pcl::PointCloud<pcl::PointXYZ>;

[[nodiscard]] inline PclCloud::Ptr to_pcl(const PointCloud& cloud) {
  auto points = pcl::make_shared<PclCloud>();
  points->reserve(cloud.points_m.size());
  for (const Eigen::Vector3f& point : cloud.points_m) points->emplace_back(point.x(), point.y(), point.z());
  return points;
}

}  // namespace rva
