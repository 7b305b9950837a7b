#include "map/map_cloud.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <iterator>
#include <optional>

#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/parallel.hpp"
#include "core/units.hpp"

namespace rva {
namespace {

/// Sums over the measurements in one voxel.
struct VoxelSum {
  std::uint64_t key = 0;
  double weight = 0.0;
  Eigen::Vector3d position_m = Eigen::Vector3d::Zero();  // weighted
  Eigen::Vector3f color = Eigen::Vector3f::Zero();
  float colored = 0.0F;  // number of points with a colour
  std::uint16_t views = 0;
};

void add(const VoxelSum& part, VoxelSum& sum) {
  sum.weight += part.weight;
  sum.position_m += part.position_m;
  sum.color += part.color;
  sum.colored += part.colored;
  sum.views = static_cast<std::uint16_t>(sum.views + part.views);
}

std::uint64_t key_of(const Eigen::Vector3d& position_m, double voxel_m) {
  constexpr int bits = 21;
  constexpr std::int64_t middle = std::int64_t{1} << (bits - 1);
  std::uint64_t key = 0;
  for (const double coordinate_m : position_m) {
    const auto cell = static_cast<std::int64_t>(std::floor(coordinate_m / voxel_m)) + middle;
    key = (key << bits) | static_cast<std::uint64_t>(cell);
  }
  return key;
}

// Merges sums of the same voxel, and sorts them by key.
void thin(std::vector<VoxelSum>& sums) {
  std::ranges::stable_sort(sums, {}, &VoxelSum::key);
  std::size_t kept = 0;
  for (std::size_t i = 1; i < sums.size(); ++i) {
    if (sums[i].key == sums[kept].key)
      add(sums[i], sums[kept]);
    else
      sums[++kept] = sums[i];
  }
  if (!sums.empty()) sums.resize(kept + 1);
}

constexpr int support_reach_px = 2;

int neighbours_on_surface(const Image<float>& disparity_px, int u, int v) {
  constexpr float same_surface_px = 1.0F;
  const float own_px = disparity_px(u, v);
  int same = -1;  // excludes the pixel itself
  for (int dv = -support_reach_px; dv <= support_reach_px; ++dv) {
    for (int du = -support_reach_px; du <= support_reach_px; ++du)
      same += std::abs(disparity_px(u + du, v + dv) - own_px) < same_surface_px ? 1 : 0;
  }
  return same;
}

std::optional<Rgb> color_at(const ViewColor& color, const Eigen::Vector3d& in_depth_camera_m) {
  const Eigen::Vector3d in_color_camera_m = color.color_from_depth * in_depth_camera_m;
  if (in_color_camera_m.z() <= 0.0) return std::nullopt;
  const Eigen::Vector2d pixel = color.camera.project(in_color_camera_m);
  if (!color.camera.contains(pixel)) return std::nullopt;
  return color.image(static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y())));
}

void add_color(const ViewColor& color, const Eigen::Vector3d& in_depth_camera_m, VoxelSum& sum) {
  const std::optional<Rgb> seen = color_at(color, in_depth_camera_m);
  if (!seen) return;
  sum.color += Eigen::Vector3f(seen->r, seen->g, seen->b);
  sum.colored += 1.0F;
}

// Whether the point lies on the surface that the view sees there, and is not occluded.
bool sees(const DepthView& view, const Eigen::Vector3d& point_m) {
  constexpr double same_surface_px = 1.0;
  if (point_m.z() <= 0.0) return false;
  const Eigen::Vector2d pixel = view.camera.project(point_m);
  if (!view.camera.contains(pixel)) return false;
  const auto seen_px = static_cast<double>(
      view.disparity_px(static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y()))));
  return std::abs(seen_px - view.stereo.disparity_px(point_m.z())) < same_surface_px;
}

// The colour camera has a narrower field of view than the depth camera, so that points without a colour take
// it from other views that see them.
void color_from_others(std::span<const MapView> views, const std::vector<Transform>& camera_from_foot,
                       VoxelSum& sum) {
  const Eigen::Vector3d position_m = sum.position_m / sum.weight;
  for (std::size_t i = 0; i < views.size(); ++i) {
    const Eigen::Vector3d point_m = camera_from_foot[i] * position_m;
    if (views[i].color && sees(views[i].depth, point_m)) add_color(*views[i].color, point_m, sum);
  }
}

std::vector<VoxelSum> voxels_of(const MapView& view, const Transform& foot_from_camera,
                                const MapCloudOptions& options) {
  throw_if_interrupted();
  const DepthView& depth = view.depth;
  const Intrinsics& camera = depth.camera;
  const Mask good = supported(depth);
  std::vector<VoxelSum> sums;
  for (int v = 0; v < camera.height; ++v) {
    for (int u = 0; u < camera.width; ++u) {
      if (good(u, v) == 0) continue;
      const double z_m = depth.stereo.depth_m(static_cast<double>(depth.disparity_px(u, v)));
      if (z_m < options.near_m || z_m > options.far_m) continue;
      const Eigen::Vector3d point_m = camera.deproject({u, v}, z_m);
      const Eigen::Vector3d position_m = foot_from_camera * point_m;
      VoxelSum sum;
      sum.key = key_of(position_m, options.voxel_mm / mm_per_m);
      sum.weight = 1.0 / (z_m * z_m * z_m * z_m);
      sum.position_m = sum.weight * position_m;
      if (view.color) add_color(*view.color, point_m, sum);
      sums.push_back(sum);
    }
  }
  thin(sums);
  for (VoxelSum& sum : sums) sum.views = 1;
  return sums;
}

MapPoint point_of(const VoxelSum& sum) {
  constexpr Rgb unknown{128, 128, 128};
  MapPoint point{(sum.position_m / sum.weight).cast<float>(), unknown, sum.views};
  if (sum.colored > 0.0F) {
    const Eigen::Vector3f mean = sum.color / sum.colored;
    const auto rounded = [](float value) { return static_cast<std::uint8_t>(std::lround(value)); };
    point.color = {rounded(mean.x()), rounded(mean.y()), rounded(mean.z())};
  }
  return point;
}

}  // namespace

void check_map_cloud_options(const MapCloudOptions& options) {
  check_options(options);
  if (options.near_m >= options.far_m)
    throw OptionError("near", fmt::format("{} m is not less than the far limit", options.near_m),
                      "give a smaller one");
}

Mask supported(const DepthView& view) {
  constexpr int least = 16;  // of 24
  const Image<float>& disparity_px = view.disparity_px;
  Mask result(disparity_px.width(), disparity_px.height());
  for (int v = support_reach_px; v < disparity_px.height() - support_reach_px; ++v) {
    for (int u = support_reach_px; u < disparity_px.width() - support_reach_px; ++u) {
      if (disparity_px(u, v) > 0.0F && neighbours_on_surface(disparity_px, u, v) >= least)
        result(u, v) = mask_set;
    }
  }
  return result;
}

std::vector<MapPoint> join_views(std::span<const MapView> views, std::span<const Transform> foot_from_camera,
                                 const MapCloudOptions& options) {
  assert(views.size() == foot_from_camera.size());
  check_map_cloud_options(options);
  std::vector<std::vector<VoxelSum>> parts(views.size());
  parallel_bands(static_cast<int>(views.size()), [&](int begin, int end) {
    for (auto i = static_cast<std::size_t>(begin); i < static_cast<std::size_t>(end); ++i)
      parts[i] = voxels_of(views[i], foot_from_camera[i], options);
  });
  std::vector<VoxelSum> sums;
  for (std::vector<VoxelSum>& part : parts) {
    sums.insert(sums.end(), part.begin(), part.end());
    part = {};
  }
  thin(sums);
  std::vector<Transform> camera_from_foot;
  for (const Transform& pose : foot_from_camera) camera_from_foot.push_back(pose.inverse());
  for (VoxelSum& sum : sums) {
    if (sum.colored == 0.0F) color_from_others(views, camera_from_foot, sum);
  }
  std::vector<MapPoint> points;
  points.reserve(sums.size());
  std::ranges::transform(sums, std::back_inserter(points), point_of);
  return points;
}

}  // namespace rva
