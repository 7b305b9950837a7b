// Cameras by name: sim:SCENE, replay:PATH.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

#include "camera/camera.hpp"
#include "depth/capture.hpp"

namespace rva::cli {

/// @param seed      of a simulated camera's noise
/// @param recording what a replayed capture may lack
/// @throws UsageError for a URI of another form; Error when what it names cannot be opened
[[nodiscard]] std::unique_ptr<Camera> open_camera(const std::string& uri, std::uint64_t seed,
                                                  const CaptureOptions& recording);

}  // namespace rva::cli
