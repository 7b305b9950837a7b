// The truth of a simulated capture.
#pragma once

#include <string>

#include "core/output_folder.hpp"
#include "sim/simulated_camera.hpp"

namespace rva {

/// Writes `truth/labels.png` (16 bits: Scene::label_of the object at a pixel, 0 for none), `truth/depth.png`
/// (16 bits, 0.1 mm, 0 for none) and `truth/truth.json` (camera pose; for every object its label, name, kind,
/// role, pose, size and number of visible pixels) into a capture that is being written.
/// @throws Error naming the file that cannot be written
void write_truth(const SimulatedCamera& camera, const OutputFolder& capture);

}  // namespace rva
