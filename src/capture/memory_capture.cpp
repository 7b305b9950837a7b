#include "capture/memory_capture.hpp"

#include <algorithm>
#include <utility>

#include "core/interrupt.hpp"

namespace rva {

MemoryCapture::MemoryCapture(CaptureInfo info, std::vector<MemoryFrame> frames)
    : Capture(std::move(info)), frames_(std::move(frames)) {
  for (std::size_t i = 0; i < frames_.size(); ++i) {
    if (frames_[i].color) with_color_.push_back(i);
  }
}

std::unique_ptr<Capture> load_to_memory(const Capture& capture, std::size_t most_bytes,
                                        const Progress& progress) {
  std::vector<MemoryFrame> loaded;
  std::size_t bytes = 0;
  const std::size_t frames = capture.depth_frames();
  for (std::size_t i = 0; i < frames && (i == 0 || bytes < most_bytes); ++i) {
    throw_if_interrupted();
    loaded.push_back(
        {capture.depth(i), capture.color_of(i), infrared_of(capture, i), capture.metadata_of(i)});
    const MemoryFrame& frame = loaded.back();
    bytes += frame.depth.size() * sizeof(std::uint16_t);
    if (frame.color) bytes += frame.color->size() * sizeof(Rgb);
    for (const auto& [imager, image] : frame.infrared) bytes += image.size() * sizeof(std::uint16_t);
    if (progress) progress("loading", i + 1, frames);
  }
  return std::make_unique<MemoryCapture>(capture.info(), std::move(loaded));
}

}  // namespace rva
