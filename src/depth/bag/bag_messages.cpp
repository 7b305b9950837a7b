#include "depth/bag/realsense_messages.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <cstring>
#include <opencv2/imgproc.hpp>

#include "core/error.hpp"
#include "core/path_text.hpp"
#include "depth/bag/ros_bytes.hpp"
#include "depth/image_file.hpp"
#include "depth/mat_view.hpp"

namespace rva {
namespace {

Error unsound(std::string_view place, const std::string& problem) {
  return {std::string(place), problem, "record it again"};
}

Error unknown_encoding(const ImageMessage& image, const char* kind, std::string_view place) {
  return unsound(place, fmt::format("a {} image is encoded as '{}', which is not known", kind,
                                    printable(image.encoding)));
}

struct Header {
  std::uint32_t sequence;
  double time_s;
  std::string_view frame_id;
};

Header take_header(RosBytes& bytes) {
  const auto sequence = bytes.number<std::uint32_t>();
  const double time_s = 1e-9 * static_cast<double>(bytes.time_ns());
  return {sequence, time_s, bytes.text()};
}

int possible_side(std::uint32_t pixels, std::string_view place) {
  if (pixels >= 1 && pixels <= max_image_pixels) return static_cast<int>(pixels);
  throw unsound(place, fmt::format("an image states a side of {} pixels", pixels));
}

// Rows may be padded.
template <typename Pixel>
Image<Pixel> copy_rows(const ImageMessage& image, std::string_view place) {
  const std::size_t used = static_cast<std::size_t>(image.width) * sizeof(Pixel);
  const auto rows = static_cast<std::size_t>(image.height);
  if (image.row_bytes < used || image.pixels.size() / image.row_bytes < rows)
    throw unsound(place, "an image has fewer bytes than its size asks for");
  Image<Pixel> copy(image.width, image.height);
  for (std::size_t v = 0; v < rows; ++v) {
    std::memcpy(copy.data() + v * static_cast<std::size_t>(image.width),
                image.pixels.data() + v * image.row_bytes, used);
  }
  return copy;
}

bool is_gray(const ImageMessage& image) { return image.encoding == "mono8" || image.encoding == "8UC1"; }

using FourBytes = std::array<std::uint8_t, 4>;
using TwoBytes = std::array<std::uint8_t, 2>;

template <typename Pixel>
ColorImage converted(const ImageMessage& image, int channels, int code, std::string_view place) {
  Image<Pixel> raw = copy_rows<Pixel>(image, place);
  ColorImage color(image.width, image.height);
  cv::Mat to(image.height, image.width, CV_8UC3, color.data());
  cv::cvtColor(cv::Mat(image.height, image.width, CV_8UC(channels), raw.data()), to, code);
  return color;
}

}  // namespace

ImageMessage parse_image_message(std::span<const std::byte> message, std::string_view place) {
  RosBytes bytes(message, place);
  const Header header = take_header(bytes);
  ImageMessage image;
  image.sequence = header.sequence;
  image.time_s = header.time_s;
  image.height = possible_side(bytes.number<std::uint32_t>(), place);
  image.width = possible_side(bytes.number<std::uint32_t>(), place);
  if (image.width > max_image_pixels / image.height) {
    throw unsound(place, fmt::format("an image of {}x{} pixels, larger than any camera of ours gives",
                                     image.width, image.height));
  }
  image.encoding = bytes.text();
  if (bytes.number<std::uint8_t>() != 0) throw unsound(place, "an image with the high byte first");
  image.row_bytes = std::max<std::uint32_t>(1, bytes.number<std::uint32_t>());
  image.pixels = bytes.list_of_bytes();
  if (header.frame_id == "1" && bytes.left() >= sizeof(float)) image.unit_m = bytes.number<float>();
  return image;
}

DepthImage depth_of(const ImageMessage& image, std::string_view place) {
  if (image.encoding != "mono16" && image.encoding != "16UC1") throw unknown_encoding(image, "depth", place);
  return copy_rows<std::uint16_t>(image, place);
}

ColorImage color_of(const ImageMessage& image, std::string_view place) {
  if (image.encoding == "rgb8") return copy_rows<Rgb>(image, place);
  if (image.encoding == "bgr8") return converted<Rgb>(image, 3, cv::COLOR_BGR2RGB, place);
  if (image.encoding == "rgba8") return converted<FourBytes>(image, 4, cv::COLOR_RGBA2RGB, place);
  if (image.encoding == "bgra8") return converted<FourBytes>(image, 4, cv::COLOR_BGRA2RGB, place);
  if (is_gray(image)) return converted<std::uint8_t>(image, 1, cv::COLOR_GRAY2RGB, place);
  const bool pairs = image.width % 2 == 0;
  if (image.encoding == "YUYV" && pairs) return converted<TwoBytes>(image, 2, cv::COLOR_YUV2RGB_YUYV, place);
  if (image.encoding == "yuv422" && pairs)
    return converted<TwoBytes>(image, 2, cv::COLOR_YUV2RGB_UYVY, place);
  throw unknown_encoding(image, "colour", place);
}

GrayImage gray_of(const ImageMessage& image, std::string_view place) {
  if (!is_gray(image)) throw unknown_encoding(image, "infrared", place);
  return copy_rows<std::uint8_t>(image, place);
}

Intrinsics parse_camera_info(std::span<const std::byte> message, std::string_view place) {
  RosBytes bytes(message, place);
  static_cast<void>(take_header(bytes));
  Intrinsics camera;
  camera.height = possible_side(bytes.number<std::uint32_t>(), place);
  camera.width = possible_side(bytes.number<std::uint32_t>(), place);
  std::string model(bytes.text());
  std::ranges::transform(model, model.begin(), [](char letter) {
    return letter == ' '                    ? '_'
           : letter >= 'A' && letter <= 'Z' ? static_cast<char>(letter - 'A' + 'a')
                                            : letter;
  });
  const auto coefficients = bytes.number<std::uint32_t>();
  bool straight = true;
  for (std::uint32_t i = 0; i < coefficients; ++i) {
    const auto coefficient = bytes.number<double>();
    straight = straight && coefficient == 0.0;
    if (i < camera.coefficients.size()) camera.coefficients[i] = coefficient;
  }
  const auto known = distortion_from_name(model);
  if (!known && !straight)
    throw unsound(place, fmt::format("the lens model '{}' is not known", printable(model)));
  camera.distortion = straight ? Distortion::none : *known;
  std::array<double, 9> k{};
  for (double& number : k) number = bytes.number<double>();
  camera.fx = k[0];
  camera.cx = k[2];
  camera.fy = k[4];
  camera.cy = k[5];
  try {
    camera.check();
  } catch (const Error& error) {
    throw unsound(place, fmt::format("camera info: {} {}", error.place(), error.problem()));
  }
  return camera;
}

Transform parse_transform_message(std::span<const std::byte> message, std::string_view place) {
  RosBytes bytes(message, place);
  std::array<double, 7> numbers{};
  for (double& number : numbers) number = bytes.number<double>();
  const Eigen::Quaterniond rotation(numbers[6], numbers[3], numbers[4], numbers[5]);
  const bool finite = std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
  if (!finite || std::abs(rotation.norm() - 1.0) > 1e-3)
    throw unsound(place, "a transform between its imagers is no rotation and translation");
  Transform transform = Transform::Identity();
  transform.linear() = rotation.normalized().toRotationMatrix();
  transform.translation() = Eigen::Vector3d(numbers[0], numbers[1], numbers[2]);
  return transform;
}

std::pair<std::string, std::string> parse_key_value(std::span<const std::byte> message,
                                                    std::string_view place) {
  RosBytes bytes(message, place);
  const std::string_view key = bytes.text();
  return {std::string(key), std::string(bytes.text())};
}

double parse_float(std::span<const std::byte> message, std::string_view place) {
  return shortest_decimal(RosBytes(message, place).number<float>());
}

double shortest_decimal(float value) {
  std::array<char, 64> text{};
  const auto written = std::to_chars(text.data(), text.data() + text.size(), value);
  double number = static_cast<double>(value);
  std::from_chars(text.data(), written.ptr, number);
  return number;
}

}  // namespace rva
