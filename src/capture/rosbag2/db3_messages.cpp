#include "capture/rosbag2/db3_messages.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "capture/recording/camera_info.hpp"
#include "capture/recording/compressed_image.hpp"
#include "capture/rosbag2/cdr_bytes.hpp"
#include "core/error.hpp"

namespace rva {
namespace {

Error unsound(std::string_view source, const std::string& problem) {
  return {std::string(source), problem, "record it again"};
}

// Calls `use` with each part between separators.
template <typename Use>
void for_each_part(std::string_view text, char separator, const Use& use) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find(separator), text.size());
    use(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
}

// The comma-separated numbers of a key.
std::vector<double> numbers(const KeyValues& values, const char* key, std::string_view source) {
  const auto found = values.find(key);
  if (found == values.end()) throw unsound(source, fmt::format("lacks {}", key));
  std::vector<double> numbers;
  for_each_part(found->second, ',', [&](std::string_view part) {
    const auto number = decimal_number(part);
    if (!number) throw unsound(source, fmt::format("states a {} that is not a number", key));
    numbers.push_back(*number);
  });
  return numbers;
}

double number(const KeyValues& values, const char* key, std::string_view source) {
  const std::vector<double> one = numbers(values, key, source);
  if (one.size() != 1) throw unsound(source, fmt::format("states {} numbers for {}", one.size(), key));
  return one.front();
}

int side(const KeyValues& values, const char* key, std::string_view source) {
  const double pixels = number(values, key, source);
  constexpr double most = std::numeric_limits<std::uint32_t>::max();
  return possible_side(static_cast<std::uint32_t>(std::clamp(pixels, 0.0, most)), source);
}

void skip_stamp(CdrBytes& bytes) {
  static_cast<void>(bytes.number<std::int32_t>());   // seconds
  static_cast<void>(bytes.number<std::uint32_t>());  // nanoseconds
}

// Returns the name of the frame.
std::string_view take_header(CdrBytes& bytes) {
  skip_stamp(bytes);
  return bytes.text();
}

}  // namespace

ImageMessage parse_db3_image(std::vector<std::byte> message, std::string_view source) {
  ImageMessage image;
  image.message = std::move(message);
  CdrBytes bytes(image.message, source);
  image.frame = take_header(bytes);
  const auto height = bytes.number<std::uint32_t>();
  set_size(image, bytes.number<std::uint32_t>(), height, source);
  image.encoding = bytes.text();
  if (bytes.number<std::uint8_t>() != 0)
    throw unsound(source, "an image is big-endian, which is not supported");
  image.row_bytes = std::max<std::uint32_t>(1, bytes.number<std::uint32_t>());
  image.pixels = bytes.list_of_bytes();
  return image;
}

ImageMessage parse_db3_compressed(std::span<const std::byte> message, std::string_view source) {
  CdrBytes bytes(message, source);
  const std::string_view frame = take_header(bytes);
  const std::string_view format = bytes.text();
  ImageMessage image = decompressed(format, bytes.list_of_bytes(), source);
  image.frame = frame;
  return image;
}

Intrinsics parse_db3_camera_info(std::span<const std::byte> message, std::string_view source) {
  CdrBytes bytes(message, source);
  static_cast<void>(take_header(bytes));
  return take_camera_info(bytes, source);
}

std::vector<StaticTransform> parse_db3_transforms(std::span<const std::byte> message,
                                                  std::string_view source) {
  CdrBytes bytes(message, source);
  return take_transforms(
      bytes, [&] { skip_stamp(bytes); }, source);
}

std::string parse_db3_text(std::span<const std::byte> message, std::string_view source) {
  return std::string(CdrBytes(message, source).text());
}

KeyValues parse_db3_values(std::span<const std::byte> message, std::string_view source) {
  KeyValues values;
  for_each_part(CdrBytes(message, source).text(), ';', [&](std::string_view pair) {
    const std::size_t key_end = std::min(pair.find('='), pair.size());
    values.emplace(pair.substr(0, key_end), pair.substr(std::min(key_end + 1, pair.size())));
  });
  return values;
}

Intrinsics intrinsics_from(const KeyValues& values, std::string_view source) {
  Intrinsics camera;
  camera.width = side(values, "width", source);
  camera.height = side(values, "height", source);
  camera.fx = number(values, "fx", source);
  camera.fy = number(values, "fy", source);
  camera.cx = number(values, "ppx", source);
  camera.cy = number(values, "ppy", source);
  const auto model = values.find("model");
  return with_lens(camera, model == values.end() ? "" : model->second, numbers(values, "coeffs", source),
                   source);
}

Transform transform_from(const KeyValues& values, std::string_view source) {
  const std::vector<double> rotation = numbers(values, "rotation", source);
  const std::vector<double> translation = numbers(values, "translation", source);
  if (rotation.size() != 9 || translation.size() != 3)
    throw unsound(source, "a transform between its imagers lacks numbers");
  const Eigen::Matrix3d stated = Eigen::Map<const Eigen::Matrix3d>(rotation.data());
  const bool turns =
      (stated.transpose() * stated - Eigen::Matrix3d::Identity()).norm() < 1e-3 && stated.determinant() > 0.0;
  if (!turns) throw unsound(source, "a transform between its imagers is not a rotation and translation");
  Transform transform = Transform::Identity();
  // The rotation is stated with six decimals, and hence not exactly orthonormal.
  transform.linear() = Eigen::Quaterniond(stated).normalized().toRotationMatrix();
  transform.translation() = Eigen::Map<const Eigen::Vector3d>(translation.data());
  return transform;
}

}  // namespace rva
