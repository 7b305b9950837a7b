// Writes a simulated capture: frames, truth, and how they were simulated.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/output_folder.hpp"
#include "core/progress.hpp"
#include "sim/simulated_camera.hpp"

namespace rva {

/// Where the camera's options and the scene's debris came from. With the scene, the seed and the options,
/// this is stated in the capture's description (`simulation` in capture.json), so that it can be simulated
/// again.
struct SimulationOrigin {
  std::string camera_model = "d435";           ///< as camera_model() takes it
  std::string debris{};                        ///< "none", or the scene file whose debris was used instead;
                                               ///< empty for the scene's own
  std::optional<std::uint64_t> debris_seed{};  ///< of debris placed at random, instead of the scene's seeds
};

/// What a simulated capture contains.
struct SimulatedCaptureOptions {
  std::size_t frames = 40;  ///< depth frames, 1 or more
  bool infrared = false;    ///< what both infrared imagers saw in the last frame, too
  bool lamp = false;  ///< infrared images of as many frames under the lamp, too; the camera must have one
};

/// The files that a simulated capture may contain, in the form that OutputFolder takes.
[[nodiscard]] std::vector<std::string> simulated_capture_files();

/// Records the camera as record() and record_lamp() do, and writes the truth (write_truth()). The caller
/// commits the folder.
/// @throws UsageError, Error, Interrupted as record()
void write_simulated_capture(SimulatedCamera& camera, const SimulationOrigin& origin,
                             const SimulatedCaptureOptions& options, const OutputFolder& out,
                             const Progress& progress);

}  // namespace rva
