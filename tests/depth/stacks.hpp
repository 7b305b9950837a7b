// Random stacks of depth images, nasty ones included.
#pragma once

#include <random>
#include <vector>

#include "capture/capture.hpp"
#include "depth/image.hpp"

namespace rva::test {

struct StackShape {
  int width = 0;
  int height = 0;
  int frames = 0;
};

/// Depths around `base` with `spread` to either side, wrapped into 1..65535, and a share of holes.
inline std::vector<DepthImage> random_stack(StackShape shape, int base, int spread, double holes,
                                            std::mt19937& random) {
  std::uniform_int_distribution<int> deviation(-spread, spread);
  std::bernoulli_distribution hole(holes);
  std::vector<DepthImage> stack;
  for (int k = 0; k < shape.frames; ++k) {
    DepthImage frame(shape.width, shape.height);
    for (std::uint16_t& depth : frame.pixels()) {
      const int value = 1 + (((base + deviation(random) - 1) % 65535) + 65535) % 65535;
      depth = hole(random) ? no_depth : static_cast<std::uint16_t>(value);
    }
    stack.push_back(std::move(frame));
  }
  return stack;
}

/// A capture whose frames lie in memory.
class MemoryCapture : public Capture {
 public:
  MemoryCapture(CaptureInfo info, std::vector<DepthImage> frames)
      : Capture(std::move(info)), frames_(std::move(frames)) {}
  [[nodiscard]] std::size_t depth_frames() const override { return frames_.size(); }
  [[nodiscard]] std::size_t color_frames() const override { return 0; }
  [[nodiscard]] DepthImage depth(std::size_t i) const override { return frames_.at(i); }
  [[nodiscard]] ColorImage color(std::size_t /*i*/) const override { return {}; }

 private:
  std::vector<DepthImage> frames_;
};

inline CaptureInfo info_of(int width, int height) {
  CaptureInfo info;
  info.depth = {width, height, 425.0, 425.0, width / 2.0 - 0.5, height / 2.0 - 0.5};
  return info;
}

inline MemoryCapture capture_of(std::vector<DepthImage> frames) {
  CaptureInfo info = info_of(frames.at(0).width(), frames.at(0).height());
  return {std::move(info), std::move(frames)};
}

}  // namespace rva::test
