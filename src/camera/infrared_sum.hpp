// The mean of the infrared images of many frames.
#pragma once

#include <cstdint>
#include <map>

#include "camera/camera.hpp"
#include "capture/capture_sink.hpp"

namespace rva {

/// Sums the infrared images of the frames of one view, by imager.
class InfraredSum {
 public:
  /// Adds the infrared images of a frame.
  /// @param frame its infrared images, if any, must have the size of its depth image
  void add(const CameraFrame& frame);

  /// Whether no infrared image has been added.
  [[nodiscard]] bool empty() const { return sums_.empty(); }

  /// Writes the mean of each imager's images, with the exposure of the last frame.
  /// @throws Error as CaptureSink::write_infrared()
  void write(Light light, CaptureSink& sink) const;

 private:
  struct Sum {
    Image<std::uint64_t> brightness;  // in the unit of FineGrayImage
    int frames = 0;
  };
  std::map<Imager, Sum> sums_;
  FrameMetadata metadata_;
};

}  // namespace rva
