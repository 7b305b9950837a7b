// Depth and colour images in files.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/error.hpp"
#include "depth/image.hpp"

namespace rva {

/// Images with more pixels are refused before memory is allocated for them. The largest depth cameras give 5
/// million pixels, and a comparison takes about 50 bytes for each.
inline constexpr long max_depth_pixels = 8L << 20;

/// The limit for colour images.
inline constexpr long max_color_pixels = 32L << 20;

/// Refuses an image without pixels or with more than `most_pixels`. @throws Error
void require_reasonable_size(long width, long height, long most_pixels, const std::string& source);

/// The error for a damaged image file. @param reason is put in brackets after "damaged image"
[[nodiscard]] Error damaged_image(const std::string& source, std::string_view reason);

/// Decodes a depth image.
/// @param png    a whole PNG file of one 16-bit channel
/// @param source  the file's name, for errors
/// @throws Error when it is damaged, ends early, has other channels or another bit depth, or is too large
[[nodiscard]] DepthImage decode_depth(std::span<const std::byte> png, const std::string& source);

/// Decodes a colour image.
/// @param file   a whole PNG or JPEG file, grey or colour; of 16-bit values, the upper 8 bits are used
/// @throws Error as decode_depth()
[[nodiscard]] ColorImage decode_color(std::span<const std::byte> file, const std::string& source);

/// The same for a file on the disk, whose path errors name.
[[nodiscard]] DepthImage read_depth(const std::filesystem::path& path);

/// Reads a PNG or JPEG file. @throws Error as decode_color(), naming the path
[[nodiscard]] ColorImage read_color(const std::filesystem::path& path);

/// Reads a PNG of one 8-bit channel. @throws Error as decode_depth()
[[nodiscard]] GrayImage read_gray(const std::filesystem::path& path);

/// Reads a PNG of one channel of 8 bits, or of 16 bits with `counts_per_grey_level` counts per grey level.
/// @return grey levels, 0 to 255, with fractions
/// @throws Error as decode_depth()
[[nodiscard]] Image<float> read_infrared(const std::filesystem::path& path, double counts_per_grey_level);

/// Encodes one channel. @param values width times height of them, row by row
[[nodiscard]] std::vector<std::byte> encode_png(std::span<const std::uint8_t> values, int width, int height);
/// @overload
[[nodiscard]] std::vector<std::byte> encode_png(std::span<const std::uint16_t> values, int width, int height);

/// Encodes an image of one channel of 8 or 16 bits.
template <typename Value, typename Meaning>
[[nodiscard]] std::vector<std::byte> encode_png(const Image<Value, Meaning>& image) {
  return encode_png(image.pixels(), image.width(), image.height());
}
/// Encodes a colour image, 8 bits per channel.
[[nodiscard]] std::vector<std::byte> encode_png(const ColorImage& image);

/// For display only, since JPEG is lossy.
/// @param quality 1 to 100
[[nodiscard]] std::vector<std::byte> encode_jpeg(const ColorImage& image, int quality);

/// @overload
[[nodiscard]] std::vector<std::byte> encode_jpeg(const GrayImage& image, int quality);

}  // namespace rva
