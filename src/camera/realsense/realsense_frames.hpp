// Converts librealsense's types to RVA's.
#pragma once

#include <librealsense2/rs.hpp>
#include <optional>

#include "capture/capture.hpp"

namespace rva {

/// Copies the depth of a frame, in the depth unit that the device is set to.
[[nodiscard]] DepthImage to_depth_image(const rs2::depth_frame& frame);
/// Copies a colour frame.
/// @param frame of RGB8
[[nodiscard]] ColorImage to_color_image(const rs2::video_frame& frame);
/// Copies an infrared frame.
/// @param frame of Y8
[[nodiscard]] GrayImage to_gray_image(const rs2::video_frame& frame);

/// Converts intrinsics. Without coefficients there is no distortion, whatever the model is named.
[[nodiscard]] Intrinsics to_intrinsics(const rs2_intrinsics& intrinsics);

/// Converts a transform, with its translation in metres.
[[nodiscard]] Transform to_transform(const rs2_extrinsics& a_from_b);

/// The metadata of the frame itself, without the temperature.
[[nodiscard]] FrameMetadata to_metadata(const rs2::depth_frame& frame);

}  // namespace rva
