// Cameras by name: sim:SCENE, replay:PATH, realsense[:SERIAL].
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "camera/camera.hpp"
#include "camera/realsense/realsense.hpp"
#include "depth/capture.hpp"

namespace rva::cli {

/// @param seed      of a simulated camera's noise
/// @param recording what a replayed capture may lack
/// @param realsense how such a camera is set
/// @throws UsageError for a URI of another form; Error when what it names cannot be opened
[[nodiscard]] std::unique_ptr<Camera> open_camera(const std::string& uri, std::uint64_t seed,
                                                  const CaptureOptions& recording,
                                                  const RealSenseOptions& realsense);

/// Whether what it sees is seen once: what a device saw cannot be recorded again.
[[nodiscard]] bool is_device(const std::string& uri);

}  // namespace rva::cli
