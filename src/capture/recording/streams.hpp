// The imagers of a recording, and the description of its camera.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "capture/capture.hpp"
#include "capture/recording/recording.hpp"

namespace rva {

/// The streams of a recording that make up a capture.
struct RecordedStreams {
  RecordedStream depth;                       ///< of the depth images
  std::optional<RecordedStream> color;        ///< of the colour images; empty where there are none
  std::map<Imager, RecordedStream> infrared;  ///< of the imagers that were recorded
  std::map<Imager, RecordedStream> lamp;      ///< likewise, of images under the lamp
};

/// Finds the streams with images of the first device, or of a camera's ROS node.
/// @param depth_topic the ROS topic of depth images, instead of the one chosen automatically
/// @throws Error naming what the recording has instead, when there is no depth
[[nodiscard]] RecordedStreams find_streams(const Recording& recording,
                                           const std::optional<std::string>& depth_topic = {});

/// The description of a recording as a capture.
/// @param intrinsics of the depth images, in place of what the recording states; the size is that of the
///                   first image
/// @throws Error when the description is incomplete or impossible
[[nodiscard]] CaptureInfo describe(const Recording& recording, const RecordedStreams& streams,
                                   const std::optional<Intrinsics>& intrinsics = {});

/// The metadata of an image.
/// @param image a message of stream.images()
/// @throws Error when the file is damaged there
[[nodiscard]] FrameMetadata metadata_of(const Recording& recording, const RecordedStream& stream,
                                        const RecordedMessage& image);

}  // namespace rva
