// Depth images as points in space.
#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>
#include <cstdint>
#include <vector>

#include "depth/image.hpp"
#include "geometry/intrinsics.hpp"

namespace rva {

struct PointCloud {
  std::vector<Eigen::Vector3f> points_m;  ///< in the camera's frame
  std::vector<std::uint32_t> pixels;      ///< of each point, by position in the rows laid end to end
};

/// Every measured pixel as a point, where it lies in a box: what PassThrough filters of the thesis (chapter
/// 3.3, figure 3.16) leave.
/// @param camera   of the image's size
/// @param unit_m   metres of one step of the image
/// @param within_m in the camera's frame
/// @throws Error where the lens bends rays
[[nodiscard]] PointCloud deproject(const DepthImage& depth, const Intrinsics& camera, double unit_m,
                                   const Eigen::AlignedBox3f& within_m);

/// The same into a cloud that was there, whose memory is used again: for one frame after the other.
void deproject(const DepthImage& depth, const Intrinsics& camera, double unit_m,
               const Eigen::AlignedBox3f& within_m, PointCloud& cloud);

}  // namespace rva
