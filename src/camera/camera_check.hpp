// How a camera does today, before work with it.
#pragma once

#include <cstddef>

#include "camera/camera.hpp"
#include "core/progress.hpp"
#include "depth/check_standard.hpp"

namespace rva {

/// Looks at a still scene for as many frames and measures what judge() compares.
/// @param frames 4 at least
/// @throws Error of the camera, or when a recording ends before; Interrupted
[[nodiscard]] CameraCheck check_camera(Camera& camera, std::size_t frames, const Progress& progress);

}  // namespace rva
