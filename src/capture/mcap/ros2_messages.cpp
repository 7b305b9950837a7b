#include "capture/mcap/ros2_messages.hpp"

#include <Eigen/Geometry>
#include <array>

#include "capture/rosbag2/cdr_writer.hpp"

namespace rva {
namespace {

constexpr std::uint64_t ns_per_s = 1'000'000'000;

void write_header(CdrWriter& message, const MessageHeader& header) {
  message.number(static_cast<std::int32_t>(header.time_ns / ns_per_s));
  message.number(static_cast<std::uint32_t>(header.time_ns % ns_per_s));
  message.text(header.frame);
}

}  // namespace

const MessageType image_type{"sensor_msgs/msg/Image", R"(std_msgs/Header header
uint32 height
uint32 width
string encoding
uint8 is_bigendian
uint32 step
uint8[] data

================================================================================
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id

================================================================================
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec
)"};

const MessageType camera_info_type{"sensor_msgs/msg/CameraInfo", R"(std_msgs/Header header
uint32 height
uint32 width
string distortion_model
float64[] d
float64[9] k
float64[9] r
float64[12] p
uint32 binning_x
uint32 binning_y
RegionOfInterest roi

================================================================================
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id

================================================================================
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec

================================================================================
MSG: sensor_msgs/RegionOfInterest
uint32 x_offset
uint32 y_offset
uint32 height
uint32 width
bool do_rectify
)"};

const MessageType transforms_type{"tf2_msgs/msg/TFMessage", R"(geometry_msgs/TransformStamped[] transforms

================================================================================
MSG: geometry_msgs/TransformStamped
std_msgs/Header header
string child_frame_id
Transform transform

================================================================================
MSG: std_msgs/Header
builtin_interfaces/Time stamp
string frame_id

================================================================================
MSG: builtin_interfaces/Time
int32 sec
uint32 nanosec

================================================================================
MSG: geometry_msgs/Transform
Vector3 translation
Quaternion rotation

================================================================================
MSG: geometry_msgs/Vector3
float64 x
float64 y
float64 z

================================================================================
MSG: geometry_msgs/Quaternion
float64 x
float64 y
float64 z
float64 w
)"};

std::vector<std::byte> image_message(const MessageHeader& header, const RawImage& image) {
  CdrWriter message;
  write_header(message, header);
  message.number(static_cast<std::uint32_t>(image.height));
  message.number(static_cast<std::uint32_t>(image.width));
  message.text(image.encoding);
  message.number(std::uint8_t{0});  // little endian
  message.number(static_cast<std::uint32_t>(image.pixels.size() / static_cast<std::size_t>(image.height)));
  message.list_of_bytes(image.pixels);
  return message.take();
}

std::vector<std::byte> camera_info_message(const MessageHeader& header, const Intrinsics& camera) {
  CdrWriter message;
  write_header(message, header);
  message.number(static_cast<std::uint32_t>(camera.height));
  message.number(static_cast<std::uint32_t>(camera.width));
  message.text("plumb_bob");
  message.number(static_cast<std::uint32_t>(camera.coefficients.size()));
  for (const double coefficient : camera.coefficients)
    message.number(camera.distortion == Distortion::brown_conrady ? coefficient : 0.0);
  message.numbers(std::array{camera.fx, 0.0, camera.cx, 0.0, camera.fy, camera.cy, 0.0, 0.0, 1.0});
  message.numbers(std::array{1.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 1.0});
  message.numbers(
      std::array{camera.fx, 0.0, camera.cx, 0.0, 0.0, camera.fy, camera.cy, 0.0, 0.0, 0.0, 1.0, 0.0});
  message.numbers(std::array<std::uint32_t, 6>{});  // no binning; the region of interest is the whole image
  message.number(std::uint8_t{0});
  return message.take();
}

std::vector<std::byte> transform_message(const MessageHeader& header, std::string_view child,
                                         const Transform& header_from_child) {
  CdrWriter message;
  message.number(std::uint32_t{1});
  write_header(message, header);
  message.text(child);
  const Eigen::Vector3d at_m = header_from_child.translation();
  const Eigen::Quaterniond turn(header_from_child.linear());
  message.numbers(std::array{at_m.x(), at_m.y(), at_m.z(), turn.x(), turn.y(), turn.z(), turn.w()});
  return message.take();
}

}  // namespace rva
