// Cameras by name: sim:SCENE, replay:PATH, realsense[:SERIAL].
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "camera/camera.hpp"
#include "camera/realsense/realsense.hpp"
#include "capture/capture.hpp"

namespace rva::cli {

/// Opens the camera that a URI names.
/// @param seed      seed of a simulated camera's noise
/// @param recording options for a replayed capture
/// @param realsense settings of a RealSense camera
/// @throws UsageError for a URI of another form; Error when what it names cannot be opened
[[nodiscard]] std::unique_ptr<Camera> open_camera(const std::string& uri, std::uint64_t seed,
                                                  const CaptureOptions& recording,
                                                  const RealSenseOptions& realsense);

/// Whether the URI names a device, whose frames cannot be recorded a second time.
[[nodiscard]] bool is_device(const std::string& uri);

}  // namespace rva::cli
