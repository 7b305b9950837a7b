// Recordings that RVA wrote: besides the images, they contain the description of the capture.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include "capture/capture.hpp"
#include "capture/recording/streams.hpp"

namespace rva {

/// Topics of a recording that RVA wrote. The names of the images are those of ROS's RealSense node.
namespace recorded_topic {
inline constexpr std::string_view description =
    "/rva/capture";                                      ///< the text of a capture.json; the last applies
inline constexpr std::string_view frame = "/rva/frame";  ///< a line of frames.jsonl, at the frame's time
inline constexpr std::string_view depth = "/camera/depth/image_rect_raw";  ///< depth images
inline constexpr std::string_view color = "/camera/color/image_raw";       ///< colour images
inline constexpr std::string_view transforms = "/tf_static";  ///< of the colour imager, and the pose
}  // namespace recorded_topic

/// The topic of an imager's images: "/camera/infra1/image_rect_raw", "/camera/infra2/lamp/image_raw".
[[nodiscard]] std::string_view infrared_topic(Imager imager, Light light);

/// The topic of intrinsics beside a topic of images.
[[nodiscard]] std::string camera_info_topic(std::string_view images);

/// Whether a recording has a description of the capture.
[[nodiscard]] bool is_described(const Recording& recording);

/// The description of a recording that has one.
/// @param intrinsics of the depth images, in place of what the recording states, without a size
/// @throws Error when it is malformed
[[nodiscard]] CaptureInfo described_info(const Recording& recording,
                                         const std::optional<Intrinsics>& intrinsics);

/// The streams of a recording with a description.
/// @throws Error when it has no complete depth image
[[nodiscard]] RecordedStreams described_streams(const Recording& recording);

}  // namespace rva
