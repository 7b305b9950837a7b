#include "depth/align.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace rva {
namespace {

// Where a place in the depth image, at a depth, lies in the colour image.
Eigen::Vector2d in_color(const CaptureInfo& info, const Eigen::Vector2d& pixel, double depth_m) {
  return info.color->project(*info.color_from_depth * info.depth.deproject(pixel, depth_m));
}

}  // namespace

DepthImage align_to_color(const DepthImage& depth, const CaptureInfo& info) {
  if (!info.color || !info.color_from_depth)
    throw Error("colour", "the capture does not say where its colour camera stands", "record it with colour");
  DepthImage aligned(info.color->width, info.color->height);
  const auto nearest_pixel = [](double at, int size) {
    return std::clamp(std::floor(at + 0.5), -1.0, static_cast<double>(size));  // beyond either edge is enough
  };
  for (int v = 0; v < depth.height(); ++v) {
    for (int u = 0; u < depth.width(); ++u) {
      const std::uint16_t here = depth(u, v);
      if (here == no_depth) continue;
      const double depth_m = here * info.depth_unit_m;
      const Eigen::Vector2d first = in_color(info, {u - 0.5, v - 0.5}, depth_m);
      const Eigen::Vector2d last = in_color(info, {u + 0.5, v + 0.5}, depth_m);
      const int left = static_cast<int>(nearest_pixel(first.x(), aligned.width()));
      const int top = static_cast<int>(nearest_pixel(first.y(), aligned.height()));
      const int right = static_cast<int>(nearest_pixel(last.x(), aligned.width()));
      const int bottom = static_cast<int>(nearest_pixel(last.y(), aligned.height()));
      if (left < 0 || top < 0 || right >= aligned.width() || bottom >= aligned.height()) continue;
      for (int y = top; y <= bottom; ++y) {
        for (int x = left; x <= right; ++x) {
          std::uint16_t& there = aligned(x, y);
          if (there == no_depth || here < there) there = here;
        }
      }
    }
  }
  return aligned;
}

}  // namespace rva
