// Synthetic depth frames and masks for timing.
#pragma once

#include <cstdint>
#include <vector>

#include "depth/image.hpp"

namespace rva::bench {

/// Frames of a stepped scene at 0.4 to 2 m in units of 0.1 mm, with noise that grows with the square of
/// depth, pixels that flicker between the two sides of a step, and holes with flickering rims.
[[nodiscard]] std::vector<DepthImage> make_frames(int count, std::uint32_t seed);

/// A mask of 848x480 pixels with blobs of 1 to about 60 pixels at random positions.
[[nodiscard]] Mask make_mask(int blobs, std::uint32_t seed);

}  // namespace rva::bench
