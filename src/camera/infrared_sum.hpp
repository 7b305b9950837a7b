// The mean of the infrared images of many frames.
#pragma once

#include <cstdint>
#include <map>

#include "camera/camera.hpp"
#include "depth/capture_writer.hpp"

namespace rva {

/// Adds up what the frames of one view have in infrared.
class InfraredSum {
 public:
  /// @param frame its infrared images, if any, are of the size of its depth image
  void add(const CameraFrame& frame);

  [[nodiscard]] bool empty() const { return sums_.empty(); }

  /// Writes the mean of each imager's images, with the exposure of the last frame.
  /// @throws Error as CaptureWriter::write_infrared()
  void write(Light light, CaptureWriter& writer) const;

 private:
  struct Sum {
    Image<std::uint64_t> brightness;  // of FineGrayImages
    int frames = 0;
  };
  std::map<Imager, Sum> sums_;
  FrameMetadata metadata_;
};

}  // namespace rva
