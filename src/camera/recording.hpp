// From a camera to a capture folder.
#pragma once

#include <cstddef>

#include "camera/camera.hpp"
#include "core/progress.hpp"
#include "depth/capture_writer.hpp"

namespace rva {

/// What was recorded.
struct Recorded {
  std::size_t frames = 0;
  std::size_t lost = 0;  ///< that the camera dropped between them, by its numbers
};

/// Writes the camera's next `frames` frames, from number 0, each with colour where it has that, and of the
/// infrared images of each imager the mean, also of the frames until something failed.
/// Other threads encode and write while the camera goes on; memory holds two frames a core, and where the
/// disk is slower than the camera, it is the camera that waits or drops. The writer is made of the camera's
/// info(), and may describe a folder that a failure leaves half full.
///
/// @throws Error       of the camera or the disk; when a recording ends before it gave so many frames
/// @throws UsageError  when frames is 0
/// @throws Interrupted between two frames
Recorded record(Camera& camera, std::size_t frames, CaptureWriter& writer, const Progress& progress);

/// Writes the mean of the infrared images that the camera's next `frames` frames have under its lamp. The
/// projector is on again afterwards, whatever happens.
/// @param camera has_lamp()
/// @throws as record(); Error when the frames have no infrared images
void record_lamp(Camera& camera, std::size_t frames, CaptureWriter& writer, const Progress& progress);

}  // namespace rva
