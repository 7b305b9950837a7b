#include "camera/memory_capture.hpp"

#include <algorithm>
#include <utility>

#include "core/interrupt.hpp"

namespace rva {

MemoryCapture::MemoryCapture(CaptureInfo info, std::vector<DepthImage> depth, std::vector<ColorImage> color)
    : Capture(std::move(info)), depth_(std::move(depth)), color_(std::move(color)) {}

std::unique_ptr<Capture> load_to_memory(const Capture& capture, std::size_t most_bytes,
                                        const Progress& progress) {
  std::vector<DepthImage> depth;
  std::vector<ColorImage> color;
  std::size_t bytes = 0;
  const std::size_t frames = capture.depth_frames();
  for (std::size_t i = 0; i < frames && (i == 0 || bytes < most_bytes); ++i) {
    throw_if_interrupted();
    depth.push_back(capture.depth(i));
    bytes += depth.back().size() * sizeof(std::uint16_t);
    if (i < capture.color_frames()) {
      color.push_back(capture.color(i));
      bytes += color.back().size() * sizeof(Rgb);
    }
    if (progress) progress("loading", i + 1, frames);
  }
  return std::make_unique<MemoryCapture>(capture.info(), std::move(depth), std::move(color));
}

}  // namespace rva
