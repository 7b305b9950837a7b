// Converts depth images to point clouds.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "depth/image.hpp"
#include "geometry/intrinsics.hpp"

namespace rva {

/// Points of a depth image, each with the pixel it comes from.
struct PointCloud {
  std::vector<Eigen::Vector3f> points_m;  ///< in the camera's frame
  std::vector<std::uint32_t> pixels;      ///< pixel of each point, as an index in row-major order
};

/// Converts every measured pixel to a point, if it lies in a box, as the PassThrough filters of the thesis do
/// (chapter 3.3, figure 3.16).
/// @param camera   intrinsics, of the size of the image
/// @param unit_m   metres of one depth unit
/// @param within_m the box, in the camera's frame
/// @throws Error when the camera has lens distortion
[[nodiscard]] PointCloud deproject(const DepthImage& depth, const Intrinsics& camera, double unit_m,
                                   const Eigen::AlignedBox3f& within_m);

/// The same, reusing the memory of an existing cloud for one frame after the other.
void deproject(const DepthImage& depth, const Intrinsics& camera, double unit_m,
               const Eigen::AlignedBox3f& within_m, PointCloud& cloud);

}  // namespace rva
