#include "capture/frozen.hpp"

#include <algorithm>
#include <utility>

namespace rva {
namespace {

bool has_measurement(const DepthImage& depth) {
  return std::ranges::any_of(depth.pixels(), [](std::uint16_t value) { return value != no_depth; });
}

}  // namespace

bool is_frozen(const Capture& capture, std::size_t frames) {
  if (frames < 2) return false;
  const DepthImage first = capture.depth(0);
  for (std::size_t k = 1; k < frames; ++k) {
    if (capture.depth(k) != first) return false;
  }
  return has_measurement(first);
}

bool are_copies(const Capture& a, std::size_t a_frames, const Capture& b, std::size_t b_frames) {
  const DepthImage first = a.depth(0);
  if (b.depth(0) != first) return false;
  for (std::size_t k = 1; k < std::min(a_frames, b_frames); ++k) {
    if (a.depth(k) != b.depth(k)) return false;
  }
  return has_measurement(first);
}

Error frozen_camera(std::string source) {
  return {std::move(source), "every frame is the same image: the camera was frozen",
          "restart the camera and capture again"};
}

}  // namespace rva
