// What a recording of realsense-viewer holds: its imagers' topics, and what it says of the camera.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "depth/bag/bag_file.hpp"
#include "depth/capture.hpp"

namespace rva {

/// The topics of one imager begin with these.
struct BagStream {
  std::string sensor;  ///< "/device_0/sensor_0/"
  std::string name;    ///< "/device_0/sensor_0/Depth_0"
};

struct BagStreams {
  BagStream depth;
  std::optional<BagStream> color;
  std::optional<BagStream> infrared;  ///< of the left imager
};

/// Those of the first device that have images.
/// @throws Error that says what is there instead, where there is no depth
[[nodiscard]] BagStreams find_streams(const BagFile& bag);

/// The messages of its images.
[[nodiscard]] const std::vector<BagMessage>& images(const BagFile& bag, const BagStream& stream);

/// @throws Error when the description is incomplete, or one that no camera can have
[[nodiscard]] CaptureInfo describe(const BagFile& bag, const BagStreams& streams);

/// @param image of the stream
/// @throws Error when the file is damaged there
[[nodiscard]] FrameMetadata metadata_of(const BagFile& bag, const BagStream& stream, const BagMessage& image);

}  // namespace rva
