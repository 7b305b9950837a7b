// Converts a capture to a point cloud, for other programs.
#pragma once

#include <vector>

#include "capture/capture.hpp"
#include "core/progress.hpp"
#include "map/map_cloud.hpp"

namespace rva {

/// One point per pixel that has a measurement in at least half of the frames: its mean depth, in the depth
/// camera's frame, with the colour of the first colour image; grey where that does not reach.
/// @throws Error when a frame cannot be read, or nothing was measured; Interrupted
[[nodiscard]] std::vector<MapPoint> points_of(const Capture& capture, const Progress& progress);

}  // namespace rva
