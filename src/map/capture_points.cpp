#include "map/capture_points.hpp"

#include <cmath>

#include "capture/frame_reader.hpp"
#include "core/error.hpp"
#include "depth/depth_statistics.hpp"

namespace rva {
namespace {

constexpr Rgb without_color{128, 128, 128};

Rgb color_at(const ColorImage& image, const CaptureInfo& info, const Eigen::Vector3d& in_depth_camera_m) {
  const Eigen::Vector3d in_color_camera_m = *info.color_from_depth * in_depth_camera_m;
  if (in_color_camera_m.z() <= 0.0) return without_color;
  const Eigen::Vector2d pixel = info.color->project(in_color_camera_m);
  if (!info.color->contains(pixel)) return without_color;
  return image(static_cast<int>(std::lround(pixel.x())), static_cast<int>(std::lround(pixel.y())));
}

}  // namespace

std::vector<MapPoint> points_of(const Capture& capture, const Progress& progress) {
  const CaptureInfo& info = capture.info();
  DepthStatistics statistics(info.depth.width, info.depth.height);
  const std::size_t frames = std::min(capture.depth_frames(), DepthStatistics::max_frames);
  for_each_depth_frame(capture, frames, progress, [&](const DepthImage& frame) { statistics.add(frame); });
  const bool colored = capture.color_frames() > 0 && info.color && info.color_from_depth;
  const ColorImage color = colored ? capture.color(0) : ColorImage();
  std::vector<MapPoint> points;
  for (int v = 0; v < info.depth.height; ++v) {
    for (int u = 0; u < info.depth.width; ++u) {
      const auto i = static_cast<std::size_t>(v) * static_cast<std::size_t>(info.depth.width) +
                     static_cast<std::size_t>(u);
      if (!statistics.seen(i)) continue;
      const Eigen::Vector3d point = info.depth.deproject({u, v}, statistics.mean(i) * info.depth_unit_m);
      points.push_back({point.cast<float>(), colored ? color_at(color, info, point) : without_color, 1});
    }
  }
  if (points.empty()) throw Error("capture", "contains no measurement", "record it again");
  return points;
}

}  // namespace rva
