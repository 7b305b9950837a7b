#include "capture/align.hpp"

#include <algorithm>
#include <cmath>

#include "core/error.hpp"

namespace rva {
namespace {

// A rectangle of pixels that includes both corners.
struct PixelRectangle {
  int left = 0, top = 0, right = 0, bottom = 0;

  [[nodiscard]] bool inside(const Intrinsics& image) const {
    return left >= 0 && top >= 0 && right < image.width && bottom < image.height;
  }
};

// Projects a point of the depth image with its depth into the colour image.
Eigen::Vector2d in_color(const CaptureInfo& info, const Eigen::Vector2d& pixel, double depth_m) {
  return info.color->project(*info.color_from_depth * info.depth.deproject(pixel, depth_m));
}

PixelRectangle seen_in_color(const CaptureInfo& info, int u, int v, double depth_m) {
  const auto nearest_pixel = [](double at, int size) {  // how far beyond an edge does not matter
    return static_cast<int>(std::clamp(std::floor(at + 0.5), -1.0, static_cast<double>(size)));
  };
  const Eigen::Vector2d first = in_color(info, {u - 0.5, v - 0.5}, depth_m);
  const Eigen::Vector2d last = in_color(info, {u + 0.5, v + 0.5}, depth_m);
  return {.left = nearest_pixel(first.x(), info.color->width),
          .top = nearest_pixel(first.y(), info.color->height),
          .right = nearest_pixel(last.x(), info.color->width),
          .bottom = nearest_pixel(last.y(), info.color->height)};
}

void keep_nearest(DepthImage& aligned, const PixelRectangle& pixels, std::uint16_t here) {
  for (int y = pixels.top; y <= pixels.bottom; ++y) {
    for (int x = pixels.left; x <= pixels.right; ++x) {
      std::uint16_t& there = aligned(x, y);
      if (there == no_depth || here < there) there = here;
    }
  }
}

}  // namespace

DepthImage align_to_color(const DepthImage& depth, const CaptureInfo& info) {
  if (!info.color || !info.color_from_depth)
    throw Error("colour", "the capture does not state the extrinsics of its colour camera",
                "record it with colour");
  DepthImage aligned(info.color->width, info.color->height);
  for (int v = 0; v < depth.height(); ++v) {
    for (int u = 0; u < depth.width(); ++u) {
      const std::uint16_t here = depth(u, v);
      if (here == no_depth) continue;
      const PixelRectangle pixels = seen_in_color(info, u, v, here * info.depth_unit_m);
      if (pixels.inside(*info.color)) keep_nearest(aligned, pixels, here);
    }
  }
  return aligned;
}

}  // namespace rva
