#include <fmt/format.h>
#include <tiffio.h>

#include <algorithm>
#include <cstdarg>
#include <cstdint>
#include <cstring>
#include <memory>

#include "capture/images/depth_file.hpp"
#include "core/error.hpp"
#include "depth/image_file.hpp"

namespace rva {
namespace {

/// A file in memory, for libtiff.
struct Bytes {
  std::span<const std::byte> all;
  std::size_t at = 0;
};

tmsize_t read_bytes(thandle_t handle, void* out, tmsize_t size) {
  Bytes& bytes = *static_cast<Bytes*>(handle);
  const std::size_t left = bytes.at < bytes.all.size() ? bytes.all.size() - bytes.at : 0;
  const std::size_t count = std::min(static_cast<std::size_t>(size), left);
  if (count > 0) std::memcpy(out, &bytes.all[bytes.at], count);
  bytes.at += count;
  return static_cast<tmsize_t>(count);
}

tmsize_t write_nothing(thandle_t /*handle*/, void* /*in*/, tmsize_t /*size*/) { return 0; }

toff_t seek(thandle_t handle, toff_t offset, int from) {
  Bytes& bytes = *static_cast<Bytes*>(handle);
  const std::size_t base = from == SEEK_CUR ? bytes.at : from == SEEK_END ? bytes.all.size() : 0;
  bytes.at = base + offset;
  return bytes.at;
}

int close_nothing(thandle_t /*handle*/) { return 0; }
toff_t size_of(thandle_t handle) { return static_cast<Bytes*>(handle)->all.size(); }

using Tiff = std::unique_ptr<TIFF, decltype(&TIFFClose)>;

Tiff open_tiff(Bytes& bytes, const std::string& source) {
  // libtiff would write messages to stderr; errors are detected by the results of its calls.
  TIFFSetErrorHandler(nullptr);
  TIFFSetWarningHandler(nullptr);
  Tiff tiff(TIFFClientOpen("depth", "rm", &bytes, read_bytes, write_nothing, seek, close_nothing, size_of,
                           nullptr, nullptr),
            TIFFClose);
  if (!tiff) throw damaged_image(source, "not a TIFF");
  return tiff;
}

template <typename Rows>
Rows rows_of(TIFF* tiff, int width, int height, const std::string& source) {
  Rows image(width, height);
  if (TIFFScanlineSize64(tiff) != static_cast<std::uint64_t>(width) * sizeof(typename Rows::Value))
    throw damaged_image(source, "the length of its rows does not match its width");
  for (int v = 0; v < height; ++v) {
    if (TIFFReadScanline(tiff, &image(0, v), static_cast<std::uint32_t>(v)) != 1)
      throw damaged_image(source, fmt::format("row {} cannot be read", v));
  }
  return image;
}

}  // namespace

StoredDepth decode_tiff(std::span<const std::byte> file, const std::string& source) {
  Bytes bytes{file};
  const Tiff tiff = open_tiff(bytes, source);
  std::uint32_t width = 0;
  std::uint32_t height = 0;
  std::uint16_t bits = 1;
  std::uint16_t samples = 1;
  std::uint16_t format = SAMPLEFORMAT_UINT;
  TIFFGetField(tiff.get(), TIFFTAG_IMAGEWIDTH, &width);
  TIFFGetField(tiff.get(), TIFFTAG_IMAGELENGTH, &height);
  TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_BITSPERSAMPLE, &bits);
  TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_SAMPLESPERPIXEL, &samples);
  TIFFGetFieldDefaulted(tiff.get(), TIFFTAG_SAMPLEFORMAT, &format);
  require_reasonable_size(width, height, max_depth_pixels, source);
  const bool whole = bits == 16 && format == SAMPLEFORMAT_UINT;
  const bool real = bits == 32 && format == SAMPLEFORMAT_IEEEFP;
  if (samples != 1 || !(whole || real) || TIFFIsTiled(tiff.get()) != 0)
    throw Error(
        source,
        fmt::format("has {} channel(s) of {} bits, but depth needs one of 16 bits, or of 32 in metres",
                    samples, bits),
        "give depth of 16 bits in one channel, or floating point in metres");
  const int columns = static_cast<int>(width);
  const int rows = static_cast<int>(height);
  if (whole) return rows_of<DepthImage>(tiff.get(), columns, rows, source);
  return rows_of<Image<float>>(tiff.get(), columns, rows, source);
}

}  // namespace rva
