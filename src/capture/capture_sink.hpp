// The interface to which frames are recorded, independent of the file format.
#pragma once

#include <cstddef>

#include "capture/capture.hpp"
#include "depth/image.hpp"

namespace rva {

/// Takes the frames of one capture. Frames of different numbers may be written on several threads at the same
/// time; write_infrared() and write_metadata() must be called by one thread.
class CaptureSink {
 public:
  CaptureSink() = default;
  virtual ~CaptureSink() = default;
  CaptureSink(const CaptureSink&) = delete;
  CaptureSink& operator=(const CaptureSink&) = delete;

  /// Writes what the camera states about a frame. Called before the images of that frame are written.
  virtual void write_metadata(std::size_t number, const FrameMetadata& metadata) = 0;

  /// @param number of the frame, 0 to 999999. Numbers may be written in any order, but none may be missing in
  ///               the end: frames are read back in the order of their numbers
  /// @param image  in the unit that the description states; 0 is no measurement
  /// @throws Error when the image is not of the size that the description states, or cannot be written
  virtual void write_depth(std::size_t number, const DepthImage& image) = 0;

  /// Writes a colour image as write_depth() writes a depth image. Any size is accepted if the description
  /// states no colour intrinsics.
  virtual void write_color(std::size_t number, const ColorImage& image) = 0;

  /// Writes the mean image of an imager under a light, its scale and its exposure.
  /// @param burst its `per_grey_level` must be that of a FineGrayImage
  /// @throws Error when the image is not of the depth images' size, or cannot be written
  virtual void write_infrared(Imager imager, Light light, const FineGrayImage& mean,
                              const InfraredBurst& burst) = 0;
};

}  // namespace rva
