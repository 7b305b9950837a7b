// One capture as points in space, for the tools of others.
#pragma once

#include <vector>

#include "core/progress.hpp"
#include "depth/capture.hpp"
#include "map/map_cloud.hpp"

namespace rva {

/// The mean of every pixel that holds a measurement in half of the frames, in the depth camera's frame, with
/// the colour of the first colour image; grey beyond it.
/// @throws Error when a frame cannot be read, or nothing was measured; Interrupted
[[nodiscard]] std::vector<MapPoint> points_of(const Capture& capture, const Progress& progress);

}  // namespace rva
