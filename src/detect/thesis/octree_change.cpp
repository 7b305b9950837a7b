#include "detect/thesis/octree_change.hpp"

#include <pcl/common/transforms.h>
#include <pcl/octree/octree_pointcloud_changedetector.h>

#include <algorithm>
#include <cassert>

#include "detect/thesis/pcl_cloud.hpp"

namespace rva {

std::vector<std::size_t> points_in_new_cells(const PointCloud& initial, const PointCloud& final,
                                             const Transform& final_from_initial, double cell_m) {
  assert(cell_m > 0.0);
  if (final.points_m.empty()) return {};
  const auto aligned = pcl::make_shared<PclCloud>();
  pcl::transformPointCloud(*to_pcl(initial), *aligned, final_from_initial.matrix().cast<float>());
  pcl::octree::OctreePointCloudChangeDetector<pcl::PointXYZ> octree(cell_m);
  octree.setInputCloud(aligned);
  octree.addPointsFromInputCloud();
  octree.switchBuffers();
  octree.setInputCloud(to_pcl(final));
  octree.addPointsFromInputCloud();
  pcl::Indices changed;
  octree.getPointIndicesFromNewVoxels(changed);
  std::vector<std::size_t> positions(changed.begin(), changed.end());
  std::ranges::sort(positions);
  return positions;
}

}  // namespace rva
