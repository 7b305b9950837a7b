// Captures of rooms of boxes, from memory.
#pragma once

#include <cmath>
#include <initializer_list>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "detect/spatial/spatial_detection.hpp"
#include "tests/depth/stacks.hpp"
#include "tests/views/box_room.hpp"

namespace rva::test {

inline constexpr double unit_m = 1e-4;

struct Shot {
  Transform at = pose(0, 0, 0);
  std::optional<std::string> base;
  std::uint64_t seed = 1;
};

inline std::unique_ptr<Capture> shoot(const Room& room, const Shot& shot) {
  CaptureInfo info;
  info.format = "rva-capture";
  info.depth = small_camera();
  info.depth_unit_m = unit_m;
  info.camera = CameraInfo{"", "", baseline_m};
  if (shot.base) info.pose = Pose{shot.base, std::nullopt, std::nullopt, shot.at};
  std::vector<DepthImage> frames;
  for (std::uint64_t k = 0; k < 4; ++k) {
    const DepthView view = view_of(room, shot.at, {0.1, 0.0, 100 * shot.seed + k});
    DepthImage frame(view.camera.width, view.camera.height);
    for (std::size_t i = 0; i < frame.size(); ++i) {
      if (!view.seen(i)) continue;
      frame[i] = static_cast<std::uint16_t>(
          std::lround(view.stereo.depth_m(static_cast<double>(view.disparity_px[i])) / unit_m));
    }
    frames.push_back(std::move(frame));
  }
  return std::make_unique<MemoryCapture>(info, std::move(frames));
}

inline Captures side(const Room& room, std::initializer_list<Shot> shots) {
  Captures captures;
  for (const Shot& shot : shots) captures.push_back(shoot(room, shot));
  return captures;
}

inline Room littered() {
  Room room = bay();
  room.boxes.push_back(box(-0.05, 0.05, 0.20, 0.25, 0.65, 0.70));
  return room;
}

}  // namespace rva::test
