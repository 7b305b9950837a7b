#include "camera/realsense/realsense_frames.hpp"

#include <algorithm>
#include <cstring>

namespace rva {
namespace {

template <typename Copy>
Copy copy_rows(const rs2::video_frame& frame) {
  Copy image(frame.get_width(), frame.get_height());
  const auto* bytes = static_cast<const std::byte*>(frame.get_data());
  const auto row_bytes = static_cast<std::size_t>(frame.get_stride_in_bytes());
  const auto width = static_cast<std::size_t>(image.width());
  for (std::size_t v = 0; v < static_cast<std::size_t>(image.height()); ++v)
    std::memcpy(image.data() + v * width, bytes + v * row_bytes, width * sizeof(typename Copy::Value));
  return image;
}

Distortion to_distortion(rs2_distortion model) {
  switch (model) {
    case RS2_DISTORTION_INVERSE_BROWN_CONRADY:
      return Distortion::inverse_brown_conrady;
    case RS2_DISTORTION_BROWN_CONRADY:
    case RS2_DISTORTION_MODIFIED_BROWN_CONRADY:
      return Distortion::brown_conrady;
    default:  // no D400 camera has another model
      return Distortion::none;
  }
}

std::optional<double> metadata_value(const rs2::frame& frame, rs2_frame_metadata_value kind) {
  if (!frame.supports_frame_metadata(kind)) return std::nullopt;
  return static_cast<double>(frame.get_frame_metadata(kind));
}

}  // namespace

DepthImage to_depth_image(const rs2::depth_frame& frame) { return copy_rows<DepthImage>(frame); }
ColorImage to_color_image(const rs2::video_frame& frame) { return copy_rows<ColorImage>(frame); }
GrayImage to_gray_image(const rs2::video_frame& frame) { return copy_rows<GrayImage>(frame); }

Intrinsics to_intrinsics(const rs2_intrinsics& intrinsics) {
  Intrinsics camera{.width = intrinsics.width,
                    .height = intrinsics.height,
                    .fx = intrinsics.fx,
                    .fy = intrinsics.fy,
                    .cx = intrinsics.ppx,
                    .cy = intrinsics.ppy};
  std::ranges::copy(intrinsics.coeffs, camera.coefficients.begin());
  const bool straight = std::ranges::all_of(camera.coefficients, [](double k) { return k == 0.0; });
  camera.distortion = straight ? Distortion::none : to_distortion(intrinsics.model);
  return camera;
}

Transform to_transform(const rs2_extrinsics& a_from_b) {
  Transform transform = Transform::Identity();
  // The rotation is stored column by column, as in Eigen.
  transform.linear() = Eigen::Map<const Eigen::Matrix3f>(a_from_b.rotation).cast<double>();
  transform.translation() = Eigen::Map<const Eigen::Vector3f>(a_from_b.translation).cast<double>();
  return transform;
}

FrameMetadata to_metadata(const rs2::depth_frame& frame) {
  FrameMetadata metadata;
  metadata.counter = frame.get_frame_number();
  metadata.time_s = 1e-3 * frame.get_timestamp();
  metadata.exposure_us = metadata_value(frame, RS2_FRAME_METADATA_ACTUAL_EXPOSURE);
  metadata.gain = metadata_value(frame, RS2_FRAME_METADATA_GAIN_LEVEL);
  metadata.laser_power_mw = metadata_value(frame, RS2_FRAME_METADATA_FRAME_LASER_POWER);
  return metadata;
}

}  // namespace rva
