// Records a camera into a capture.
#pragma once

#include <cstddef>

#include "camera/camera.hpp"
#include "capture/capture_sink.hpp"
#include "core/progress.hpp"

namespace rva {

/// The extent of a recording.
struct Recorded {
  std::size_t frames = 0;  ///< number of frames that were written
  std::size_t lost = 0;    ///< dropped by the camera between them, by the frame numbers
};

/// Writes the camera's next `frames` frames, numbered from 0, with their colour images if any, and the mean
/// infrared image of each imager. After a failure, the sink has the frames written until then, and their
/// mean infrared images.
///
/// Other threads encode and write the frames. At most two frames per core are in memory: if the disk is
/// slower than the camera, a device drops frames and other cameras wait.
///
/// @param sink         constructed with the camera's info()
/// @throws Error       when the camera or the disk fails, or a recording has too few frames
/// @throws UsageError  when frames is 0
/// @throws Interrupted between two frames
Recorded record(Camera& camera, std::size_t frames, CaptureSink& sink, const Progress& progress);

/// Writes the mean infrared image of each imager over the camera's next `frames` frames under its lamp. The
/// projector is switched on again afterwards, also after a failure.
/// @param camera must have a lamp (has_lamp())
/// @throws Error, UsageError, Interrupted as record(); Error also when the frames have no infrared images
void record_lamp(Camera& camera, std::size_t frames, CaptureSink& sink, const Progress& progress);

}  // namespace rva
