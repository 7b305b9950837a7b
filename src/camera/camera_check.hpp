// Checks a camera before work with it.
#pragma once

#include <cstddef>

#include "camera/camera.hpp"
#include "camera/check_standard.hpp"
#include "core/progress.hpp"

namespace rva {

/// Records frames of a still scene and measures the quantities that judge() compares.
/// @param frames number of frames, at least 4
/// @throws Error when the camera fails, or a recording ends too early; Interrupted
[[nodiscard]] CameraCheck check_camera(Camera& camera, std::size_t frames, const Progress& progress);

}  // namespace rva
