// Reads depth frames in order, decoding ahead on all cores.
#pragma once

#include <cstddef>
#include <functional>

#include "capture/capture.hpp"
#include "core/progress.hpp"

namespace rva {

/// Calls `use` on the calling thread with the first `count` depth frames of the capture, in order, while
/// other threads decode the next ones. At most two frames per core are in memory, however many there are.
///
/// @param count at most capture.depth_frames()
/// @throws Error of the first frame that cannot be read; Interrupted
void for_each_depth_frame(const Capture& capture, std::size_t count, const Progress& progress,
                          const std::function<void(const DepthImage&)>& use);

}  // namespace rva
