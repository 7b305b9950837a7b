#include "depth/image_file.hpp"

#include <fmt/format.h>
#include <spng.h>
#include <turbojpeg.h>

#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

constexpr const char* copy_again = "copy or record it again";

using Spng = std::unique_ptr<spng_ctx, decltype(&spng_ctx_free)>;
struct TurboJpegDelete {
  void operator()(void* handle) const { tjDestroy(handle); }
};
using TurboJpeg = std::unique_ptr<void, TurboJpegDelete>;

// Returns a decoder whose header has been read and checked, ready for spng_decode_image().
Spng open_png(std::span<const std::byte> png, long most_pixels, const std::string& source,
              spng_ihdr& header) {
  if (png.empty()) throw damaged_image(source, "the file is empty");
  Spng decoder(spng_ctx_new(0), spng_ctx_free);
  spng_set_chunk_limits(decoder.get(), 1U << 20U, 1U << 20U);
  spng_set_png_buffer(decoder.get(), png.data(), png.size());
  if (const int error = spng_get_ihdr(decoder.get(), &header))
    throw damaged_image(source, spng_strerror(error));
  require_reasonable_size(header.width, header.height, most_pixels, source);
  return decoder;
}

void decode_png(spng_ctx* decoder, int format, void* out, std::size_t size, const std::string& source) {
  int error = spng_decode_image(decoder, out, size, format, 0);
  // Read on to the end mark: a file without it was truncated, even if all pixels happen to be there.
  if (error == 0) error = spng_decode_chunks(decoder);
  if (error != 0) throw damaged_image(source, spng_strerror(error));
}

ColorImage decode_color_png(std::span<const std::byte> png, const std::string& source) {
  spng_ihdr header{};
  const Spng decoder = open_png(png, max_color_pixels, source, header);
  ColorImage image(static_cast<int>(header.width), static_cast<int>(header.height));
  decode_png(decoder.get(), SPNG_FMT_RGB8, image.data(), image.size() * sizeof(Rgb), source);
  return image;
}

ColorImage decode_jpeg(std::span<const std::byte> jpeg, const std::string& source) {
  const TurboJpeg decoder(tjInitDecompress());
  const auto* bytes = reinterpret_cast<const unsigned char*>(jpeg.data());
  int width = 0;
  int height = 0;
  int subsampling = 0;
  int color_space = 0;
  if (tjDecompressHeader3(decoder.get(), bytes, jpeg.size(), &width, &height, &subsampling, &color_space) !=
      0) {
    throw damaged_image(source, tjGetErrorStr2(decoder.get()));
  }
  require_reasonable_size(width, height, max_color_pixels, source);
  ColorImage image(width, height);
  // Without TJFLAG_STOPONWARNING, a truncated JPEG is filled with grey and decoded without an error.
  if (tjDecompress2(decoder.get(), bytes, jpeg.size(), reinterpret_cast<unsigned char*>(image.data()), width,
                    0, height, TJPF_RGB, TJFLAG_STOPONWARNING | TJFLAG_LIMITSCANS) != 0) {
    throw damaged_image(source, tjGetErrorStr2(decoder.get()));
  }
  return image;
}

std::vector<std::byte> encode(int width, int height, std::uint8_t color_type, std::uint8_t bit_depth,
                              const void* pixels, std::size_t size) {
  const Spng encoder(spng_ctx_new(SPNG_CTX_ENCODER), spng_ctx_free);
  spng_set_option(encoder.get(), SPNG_ENCODE_TO_BUFFER, 1);
  // Speed matters more than the size on the disk, since the user waits for the result.
  spng_set_option(encoder.get(), SPNG_IMG_COMPRESSION_LEVEL, 1);
  // Trying every filter on every row takes half of the time; on depth images this one compresses as well.
  spng_set_option(encoder.get(), SPNG_FILTER_CHOICE, SPNG_FILTER_CHOICE_UP);
  spng_ihdr header{};
  header.width = static_cast<std::uint32_t>(width);
  header.height = static_cast<std::uint32_t>(height);
  header.color_type = color_type;
  header.bit_depth = bit_depth;
  spng_set_ihdr(encoder.get(), &header);
  int error = spng_encode_image(encoder.get(), pixels, size, SPNG_FMT_PNG, SPNG_ENCODE_FINALIZE);
  std::size_t length = 0;
  const std::unique_ptr<void, decltype(&std::free)> png(
      error == 0 ? spng_get_png_buffer(encoder.get(), &length, &error) : nullptr, std::free);
  if (error != 0)
    throw Error("image", fmt::format("cannot be encoded ({})", spng_strerror(error)), "free some memory");
  std::vector<std::byte> bytes(length);
  std::memcpy(bytes.data(), png.get(), length);
  return bytes;
}

std::vector<std::byte> encode_jpeg(const unsigned char* pixels, int width, int height, int format,
                                   int quality) {
  const TurboJpeg encoder(tjInitCompress());
  const int subsampling = format == TJPF_GRAY ? TJSAMP_GRAY : TJSAMP_420;
  unsigned char* jpeg = nullptr;
  unsigned long size = 0;
  const int failed = tjCompress2(encoder.get(), pixels, width, 0, height, format, &jpeg, &size, subsampling,
                                 quality, TJFLAG_FASTDCT);
  const std::unique_ptr<unsigned char, decltype(&tjFree)> owned(jpeg, &tjFree);
  if (failed != 0) throw Error("JPEG", tjGetErrorStr2(encoder.get()), "free some memory");
  const auto bytes = std::as_bytes(std::span(jpeg, size));
  return {bytes.begin(), bytes.end()};
}

}  // namespace

void require_reasonable_size(long width, long height, long most_pixels, const std::string& source) {
  if (width > 0 && height > 0 && width <= most_pixels / height) return;
  throw Error(source, fmt::format("an image of {}x{} pixels is larger than any camera gives", width, height),
              "check that it is the right file");
}

Error damaged_image(const std::string& source, std::string_view reason) {
  return {source, fmt::format("damaged image ({})", reason), copy_again};
}

DepthImage decode_depth(std::span<const std::byte> png, const std::string& source) {
  spng_ihdr header{};
  const Spng decoder = open_png(png, max_depth_pixels, source, header);
  if (header.color_type != SPNG_COLOR_TYPE_GRAYSCALE || header.bit_depth != 16) {
    throw Error(
        source,
        fmt::format("has {} channel(s) of {} bits, but depth needs one of 16 bits",
                    header.color_type == SPNG_COLOR_TYPE_GRAYSCALE ? "one" : "several", header.bit_depth),
        "record depth as 16-bit grey PNG");
  }
  DepthImage image(static_cast<int>(header.width), static_cast<int>(header.height));
  // SPNG_FMT_PNG gives one channel of 16 bits in the byte order of this machine.
  decode_png(decoder.get(), SPNG_FMT_PNG, image.data(), image.size() * sizeof(std::uint16_t), source);
  return image;
}

ColorImage decode_color(std::span<const std::byte> file, const std::string& source) {
  const bool jpeg = file.size() >= 2 && file[0] == std::byte{0xFF} && file[1] == std::byte{0xD8};
  return jpeg ? decode_jpeg(file, source) : decode_color_png(file, source);
}

DepthImage read_depth(const std::filesystem::path& path) {
  return decode_depth(read_file(path), printable(path));
}

ColorImage read_color(const std::filesystem::path& path) {
  return decode_color(read_file(path), printable(path));
}

GrayImage read_gray(const std::filesystem::path& path) {
  const std::string source = printable(path);
  const std::vector<std::byte> png = read_file(path);
  spng_ihdr header{};
  const Spng decoder = open_png(png, max_depth_pixels, source, header);
  if (header.color_type != SPNG_COLOR_TYPE_GRAYSCALE || header.bit_depth != 8)
    throw Error(source, "not one channel of 8 bits", "give an 8-bit grey PNG");
  GrayImage image(static_cast<int>(header.width), static_cast<int>(header.height));
  decode_png(decoder.get(), SPNG_FMT_PNG, image.data(), image.size(), source);
  return image;
}

Image<float> read_infrared(const std::filesystem::path& path, double counts_per_grey_level) {
  const std::string source = printable(path);
  const std::vector<std::byte> png = read_file(path);
  spng_ihdr header{};
  const Spng decoder = open_png(png, max_depth_pixels, source, header);
  const bool wide = header.bit_depth == 16;
  if (header.color_type != SPNG_COLOR_TYPE_GRAYSCALE || (header.bit_depth != 8 && !wide))
    throw Error(source, "not one channel of 8 or 16 bits", "record infrared as grey PNG");
  const auto width = static_cast<int>(header.width);
  const auto height = static_cast<int>(header.height);
  Image<float> image(width, height);
  const auto fill = [&]<typename Pixel, typename Meaning>(Image<Pixel, Meaning> counts, float per_level) {
    decode_png(decoder.get(), SPNG_FMT_PNG, counts.data(), counts.size() * sizeof(Pixel), source);
    for (std::size_t i = 0; i < image.size(); ++i) image[i] = static_cast<float>(counts[i]) / per_level;
  };
  if (wide)
    fill(Image<std::uint16_t>(width, height), static_cast<float>(counts_per_grey_level));
  else
    fill(GrayImage(width, height), 1.0F);
  return image;
}

std::vector<std::byte> encode_png(std::span<const std::uint8_t> values, int width, int height) {
  return encode(width, height, SPNG_COLOR_TYPE_GRAYSCALE, 8, values.data(), values.size_bytes());
}

std::vector<std::byte> encode_png(std::span<const std::uint16_t> values, int width, int height) {
  return encode(width, height, SPNG_COLOR_TYPE_GRAYSCALE, 16, values.data(), values.size_bytes());
}

std::vector<std::byte> encode_jpeg(const ColorImage& image, int quality) {
  return encode_jpeg(reinterpret_cast<const unsigned char*>(image.data()), image.width(), image.height(),
                     TJPF_RGB, quality);
}

std::vector<std::byte> encode_jpeg(const GrayImage& image, int quality) {
  return encode_jpeg(image.data(), image.width(), image.height(), TJPF_GRAY, quality);
}

std::vector<std::byte> encode_png(const ColorImage& image) {
  return encode(image.width(), image.height(), SPNG_COLOR_TYPE_TRUECOLOR, 8, image.data(),
                image.size() * sizeof(Rgb));
}

}  // namespace rva
