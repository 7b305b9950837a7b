#include "detect/thesis/point_cloud.hpp"

#include <algorithm>
#include <cassert>
#include <cstring>
#include <limits>
#include <numeric>
#include <span>

#include "core/error.hpp"

namespace rva {
namespace {

struct Range {
  float low = 0.0F;
  float high = 0.0F;
};

// Depths at which a ray with the lateral slope `aside_by_z` lies between two planes parallel to the axis.
Range depths_between(float low_m, float high_m, float aside_by_z) {
  constexpr float infinity = std::numeric_limits<float>::infinity();
  if (aside_by_z == 0.0F)
    return low_m <= 0.0F && high_m >= 0.0F ? Range{0.0F, infinity} : Range{infinity, 0.0F};
  const auto [low, high] = std::minmax({low_m / aside_by_z, high_m / aside_by_z});
  return {low, high};
}

/// Deprojects row by row, so that the working memory stays in the cache.
class Deprojection {
 public:
  Deprojection(const Intrinsics& camera, double unit_m, const Eigen::AlignedBox3f& within_m)
      : unit_m_(static_cast<float>(unit_m)), within_m_(within_m) {
    for (int u = 0; u < camera.width; ++u) {
      right_by_z_.push_back(static_cast<float>((u - camera.cx) / camera.fx));
      const Range column = depths_between(within_m.min().x(), within_m.max().x(), right_by_z_.back());
      low_m_.push_back(column.low);
      high_m_.push_back(column.high);
    }
    z_m_.resize(right_by_z_.size());
    counts_.resize(right_by_z_.size());
  }

  void append(std::span<const std::uint16_t> depth, float down_by_z, std::uint32_t pixel, PointCloud& cloud) {
    add_row(depth, down_by_z);
    // Points are appended in runs, which are long on surfaces.
    for (std::size_t first = next(0, 1); first < depth.size();) {
      const std::size_t end = next(first, 0);
      append_run(first, end, down_by_z, cloud);
      cloud.pixels.resize(cloud.points_m.size());
      std::iota(cloud.pixels.end() - static_cast<std::ptrdiff_t>(end - first), cloud.pixels.end(),
                pixel + static_cast<std::uint32_t>(first));
      first = next(end, 1);
    }
  }

 private:
  void add_row(std::span<const std::uint16_t> depth, float down_by_z) {
    const Range row = depths_between(within_m_.min().y(), within_m_.max().y(), down_by_z);
    const float low_m = std::max({row.low, within_m_.min().z(), std::numeric_limits<float>::min()});
    const float high_m = std::min(row.high, within_m_.max().z());
    for (std::size_t u = 0; u < depth.size(); ++u) {
      const float z = unit_m_ * static_cast<float>(depth[u]);
      z_m_[u] = z;
      const int in_box = static_cast<int>(z >= low_m) & static_cast<int>(z <= high_m);
      const int in_column = static_cast<int>(z >= low_m_[u]) & static_cast<int>(z <= high_m_[u]);
      counts_[u] = static_cast<std::uint8_t>(in_box & in_column);
    }
  }

  // The first column at or after `from` whose count equals `count`; one past the last column if there
  // is none.
  [[nodiscard]] std::size_t next(std::size_t from, int count) const {
    const void* const found = std::memchr(counts_.data() + from, count, counts_.size() - from);
    return found == nullptr
               ? counts_.size()
               : static_cast<std::size_t>(static_cast<const std::uint8_t*>(found) - counts_.data());
  }

  void append_run(std::size_t first, std::size_t end, float down_by_z, PointCloud& cloud) const {
    const std::size_t begin = cloud.points_m.size();
    cloud.points_m.resize(begin + end - first);
    for (std::size_t u = first; u < end; ++u)
      cloud.points_m[begin + u - first] = {right_by_z_[u] * z_m_[u], down_by_z * z_m_[u], z_m_[u]};
  }

  float unit_m_;
  Eigen::AlignedBox3f within_m_;
  std::vector<float> right_by_z_;
  std::vector<float> low_m_;  // range of depths of each column within the box
  std::vector<float> high_m_;
  std::vector<float> z_m_;
  std::vector<std::uint8_t> counts_;  // 1 where a point lies in the box
};

}  // namespace

PointCloud deproject(const DepthImage& depth, const Intrinsics& camera, double unit_m,
                     const Eigen::AlignedBox3f& within_m) {
  PointCloud cloud;
  deproject(depth, camera, unit_m, within_m, cloud);
  return cloud;
}

void deproject(const DepthImage& depth, const Intrinsics& camera, double unit_m,
               const Eigen::AlignedBox3f& within_m, PointCloud& cloud) {
  assert(depth.width() == camera.width && depth.height() == camera.height);
  if (camera.distortion != Distortion::none)
    throw Error("depth intrinsics", "lens distortion is not supported here",
                "record rectified depth, as stereo cameras provide it");
  cloud.points_m.clear();
  cloud.pixels.clear();
  cloud.points_m.reserve(depth.size());
  cloud.pixels.reserve(depth.size());
  Deprojection deprojection(camera, unit_m, within_m);
  const auto width = static_cast<std::size_t>(depth.width());
  for (int v = 0; v < depth.height(); ++v) {
    const std::size_t start = static_cast<std::size_t>(v) * width;
    deprojection.append(depth.pixels().subspan(start, width), static_cast<float>((v - camera.cy) / camera.fy),
                        static_cast<std::uint32_t>(start), cloud);
  }
}

}  // namespace rva
