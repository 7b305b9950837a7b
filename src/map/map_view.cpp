#include "map/map_view.hpp"

#include <utility>

#include "capture/frame_reader.hpp"
#include "core/error.hpp"
#include "detect/findings/detection.hpp"

namespace rva {
namespace {

PanTilt joints_of(const CaptureInfo& info, const std::string& name) {
  if (info.pose && info.pose->pan_deg && info.pose->tilt_deg)
    return {*info.pose->pan_deg, *info.pose->tilt_deg};
  throw Error(name, "does not state the joint angles (pose.pan_deg, pose.tilt_deg)",
              "give captures of a camera on a robot, such as those that rva map writes");
}

std::optional<ViewColor> color_of(const Capture& capture) {
  const CaptureInfo& info = capture.info();
  if (capture.color_frames() == 0 || !info.color) return std::nullopt;
  return ViewColor{capture.color(capture.color_frames() - 1), *info.color,
                   info.color_from_depth.value_or(Transform::Identity())};
}

}  // namespace

MapView load_map_view(const Capture& capture, const std::string& name) {
  return load_map_view(capture, name, joints_of(capture.info(), name));
}

MapView load_map_view(const Capture& capture, const std::string& name, const PanTilt& joints) {
  const CaptureInfo& info = capture.info();
  DepthStatistics statistics(info.depth.width, info.depth.height);
  for_each_depth_frame(capture, capture.depth_frames(), {},
                       [&](const DepthImage& frame) { statistics.add(frame); });
  return {name, joints, depth_view(statistics, info.depth, stereo_scale(info)), color_of(capture)};
}

}  // namespace rva
