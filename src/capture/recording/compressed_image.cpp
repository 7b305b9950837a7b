#include "capture/recording/compressed_image.hpp"

#include <fmt/format.h>

#include <cstring>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/path_text.hpp"
#include "depth/image_file.hpp"

namespace rva {
namespace {

/// What precedes the PNG of compressedDepth (compressed_depth_image_transport, ConfigHeader).
struct DepthHeader {
  std::int32_t unused;
  float quant_a;
  float quant_b;
};

template <typename Pixel, typename Meaning>
ImageMessage message_of(const Image<Pixel, Meaning>& image, std::string_view encoding) {
  ImageMessage message;
  const auto bytes = std::as_bytes(image.pixels());
  message.message.assign(bytes.begin(), bytes.end());
  message.width = image.width();
  message.height = image.height();
  message.encoding = encoding;
  message.row_bytes = sizeof(Pixel) * static_cast<std::size_t>(image.width());
  message.pixels = message.message;
  return message;
}

// Inverse depth is quantised: a stored value q other than 0 is a depth of a / (q - b) metres.
Image<float> dequantised(const DepthImage& stored, const DepthHeader& header) {
  Image<float> depth_m(stored.width(), stored.height(), std::numeric_limits<float>::quiet_NaN());
  for (std::size_t i = 0; i < stored.size(); ++i) {
    if (stored[i] != 0) depth_m[i] = header.quant_a / (static_cast<float>(stored[i]) - header.quant_b);
  }
  return depth_m;
}

ImageMessage decompressed_depth(std::string_view format, std::span<const std::byte> data,
                                const std::string& source) {
  DepthHeader header{};
  if (data.size() < sizeof header || format.find("rvl") != std::string_view::npos)
    throw Error(source, fmt::format("depth is compressed as '{}', which is not supported", printable(format)),
                "record it with png_level, or without compression");
  std::memcpy(&header, data.data(), sizeof header);
  const DepthImage stored = decode_depth(data.subspan(sizeof header), source);
  if (format.starts_with("32FC1")) return message_of(dequantised(stored, header), "32FC1");
  return message_of(stored, "16UC1");
}

}  // namespace

bool is_compressed_image(std::string_view message_type) {
  return message_type == "sensor_msgs/CompressedImage" || message_type == "sensor_msgs/msg/CompressedImage";
}

std::string_view without_transport(std::string_view topic) {
  for (const std::string_view transport : {"/compressedDepth", "/compressed"}) {
    if (topic.ends_with(transport)) return topic.substr(0, topic.size() - transport.size());
  }
  return topic;
}

ImageMessage decompressed(std::string_view format, std::span<const std::byte> data, std::string_view source) {
  const std::string name(source);
  if (format.find("compressedDepth") != std::string_view::npos) return decompressed_depth(format, data, name);
  if (format.starts_with("16UC1")) return message_of(decode_depth(data, name), "16UC1");
  return message_of(decode_color(data, name), "rgb8");
}

}  // namespace rva
