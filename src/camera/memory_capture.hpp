// A capture whose frames are in memory.
#pragma once

#include <cstddef>
#include <memory>
#include <vector>

#include "core/progress.hpp"
#include "depth/capture.hpp"

namespace rva {

/// For a recording that is seen again and again: decoding takes longer than showing.
class MemoryCapture : public Capture {
 public:
  /// @param depth at least one, of the size that `info` states
  /// @param color as many or fewer
  MemoryCapture(CaptureInfo info, std::vector<DepthImage> depth, std::vector<ColorImage> color);

  [[nodiscard]] std::size_t depth_frames() const override { return depth_.size(); }
  [[nodiscard]] std::size_t color_frames() const override { return color_.size(); }
  [[nodiscard]] DepthImage depth(std::size_t i) const override { return depth_[i]; }
  [[nodiscard]] ColorImage color(std::size_t i) const override { return color_[i]; }

 private:
  std::vector<DepthImage> depth_;
  std::vector<ColorImage> color_;
};

/// The first frames of a capture, as many as fit.
/// @param most_bytes room for one frame is always taken
/// @throws Error when a frame cannot be read; Interrupted
[[nodiscard]] std::unique_ptr<Capture> load_to_memory(const Capture& capture, std::size_t most_bytes,
                                                      const Progress& progress);

}  // namespace rva
