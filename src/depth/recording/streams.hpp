// Which imagers a recording is of, and what it says of the camera.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "depth/capture.hpp"
#include "depth/recording/recording.hpp"

namespace rva {

struct RecordedStreams {
  RecordedStream depth;
  std::optional<RecordedStream> color;
  std::map<Imager, RecordedStream> infrared;  ///< of the imagers that were recorded
};

/// Those of the first device that have images, or of a camera's node in ROS.
/// @param depth_topic of ROS, instead of the one that would be chosen
/// @throws Error that says what is there instead, where there is no depth
[[nodiscard]] RecordedStreams find_streams(const Recording& recording,
                                           const std::optional<std::string>& depth_topic = {});

/// @param intrinsics of the depth images, whatever the recording states of them; their size is that of the
///                   first image
/// @throws Error when the description is incomplete, or one that no camera can have
[[nodiscard]] CaptureInfo describe(const Recording& recording, const RecordedStreams& streams,
                                   const std::optional<Intrinsics>& intrinsics = {});

/// @param image of the stream
/// @throws Error when the file is damaged there
[[nodiscard]] FrameMetadata metadata_of(const Recording& recording, const RecordedStream& stream,
                                        const RecordedMessage& image);

}  // namespace rva
