#include "capture/rosbag1/bag_messages.hpp"

#include <algorithm>
#include <array>
#include <charconv>

#include "capture/recording/camera_info.hpp"
#include "capture/recording/compressed_image.hpp"
#include "capture/rosbag1/ros_bytes.hpp"
#include "core/error.hpp"

namespace rva {
namespace {

Error unsound(std::string_view source, const std::string& problem) {
  return {std::string(source), problem, "record it again"};
}

struct Header {
  std::uint32_t sequence;
  double time_s;
  std::string_view frame_id;
};

// The shortest decimal number that rounds to the value: 0.001, not 0.0010000000475.
double shortest_decimal(float value) {
  std::array<char, 64> text{};
  const auto written = std::to_chars(text.data(), text.data() + text.size(), value);
  double number = static_cast<double>(value);
  std::from_chars(text.data(), written.ptr, number);
  return number;
}

Header take_header(RosBytes& bytes) {
  const auto sequence = bytes.number<std::uint32_t>();
  const double time_s = 1e-9 * static_cast<double>(bytes.time_ns());
  return {sequence, time_s, bytes.text()};
}

}  // namespace

ImageMessage parse_image_message(std::vector<std::byte> message, std::string_view source) {
  ImageMessage image;
  image.message = std::move(message);
  RosBytes bytes(image.message, source);
  const Header header = take_header(bytes);
  image.counter = header.sequence;
  image.time_s = header.time_s;
  image.frame = header.frame_id;
  const auto height = bytes.number<std::uint32_t>();
  set_size(image, bytes.number<std::uint32_t>(), height, source);
  image.encoding = bytes.text();
  if (bytes.number<std::uint8_t>() != 0)
    throw unsound(source, "an image is big-endian, which is not supported");
  image.row_bytes = std::max<std::uint32_t>(1, bytes.number<std::uint32_t>());
  image.pixels = bytes.list_of_bytes();
  if (header.frame_id == "1" && bytes.left() >= sizeof(float))
    image.unit_m = shortest_decimal(bytes.number<float>());
  return image;
}

ImageMessage parse_compressed_message(std::span<const std::byte> message, std::string_view source) {
  RosBytes bytes(message, source);
  const Header header = take_header(bytes);
  const std::string_view format = bytes.text();
  ImageMessage image = decompressed(format, bytes.list_of_bytes(), source);
  image.counter = header.sequence;
  image.time_s = header.time_s;
  image.frame = header.frame_id;
  return image;
}

Intrinsics parse_camera_info(std::span<const std::byte> message, std::string_view source) {
  RosBytes bytes(message, source);
  static_cast<void>(take_header(bytes));
  return take_camera_info(bytes, source);
}

Transform parse_transform_message(std::span<const std::byte> message, std::string_view source) {
  RosBytes bytes(message, source);
  std::array<double, 7> numbers{};
  for (double& number : numbers) number = bytes.number<double>();
  return transform_from_ros(numbers, source);
}

std::vector<StaticTransform> parse_transforms(std::span<const std::byte> message, std::string_view source) {
  RosBytes bytes(message, source);
  const auto skip_stamp = [&] {
    static_cast<void>(bytes.number<std::uint32_t>());  // sequence
    static_cast<void>(bytes.time_ns());
  };
  return take_transforms(bytes, skip_stamp, source);
}

std::pair<std::string, std::string> parse_key_value(std::span<const std::byte> message,
                                                    std::string_view source) {
  RosBytes bytes(message, source);
  const std::string_view key = bytes.text();
  return {std::string(key), std::string(bytes.text())};
}

double parse_float(std::span<const std::byte> message, std::string_view source) {
  return shortest_decimal(RosBytes(message, source).number<float>());
}

}  // namespace rva
