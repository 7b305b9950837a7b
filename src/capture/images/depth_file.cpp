#include "capture/images/depth_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cctype>
#include <charconv>
#include <cstdint>
#include <cstring>

#include "capture/formats.hpp"
#include "capture/no_depth.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/path_text.hpp"
#include "depth/image_file.hpp"

namespace rva {
namespace {

static_assert(std::endian::native == std::endian::little);

Error other_content(const std::string& source, const std::string& content) {
  return {source, content, "give depth of 16 bits in one channel, or floating point in metres"};
}

std::string_view as_text(std::span<const std::byte> bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

// Copies pixels from the file's bytes and converts their type.
template <typename Stored, typename Pixels>
Pixels pixels_from(std::span<const std::byte> bytes, int width, int height, const std::string& source) {
  Pixels image(width, height);
  if (bytes.size() < image.size() * sizeof(Stored)) throw damaged_image(source, "it ends early");
  for (std::size_t i = 0; i < image.size(); ++i) {
    Stored value;
    std::memcpy(&value, &bytes[i * sizeof(Stored)], sizeof value);
    image[i] = static_cast<typename Pixels::Value>(value);
  }
  return image;
}

/// The header of a PGM file: numbers separated by white space and comments.
class PgmHeader {
 public:
  PgmHeader(std::string_view text, const std::string& source) : text_(text), source_(source) {}

  [[nodiscard]] int number() {
    skip_space();
    int value = 0;
    const char* const begin = text_.data() + at_;
    const auto [end, failure] = std::from_chars(begin, text_.data() + text_.size(), value);
    if (failure != std::errc{}) throw damaged_image(source_, "its header lacks a number");
    at_ += static_cast<std::size_t>(end - begin);
    return value;
  }
  /// Offset of the pixels, after the one character that ends the header.
  [[nodiscard]] std::size_t pixels_at() const { return at_ + 1; }

 private:
  void skip_space() {
    while (at_ < text_.size() &&
           (std::isspace(static_cast<unsigned char>(text_[at_])) != 0 || text_[at_] == '#')) {
      if (text_[at_] == '#') at_ = std::min(text_.find('\n', at_), text_.size() - 1);
      ++at_;
    }
  }

  std::string_view text_;
  const std::string& source_;
  std::size_t at_ = 2;  // after "P5"
};

// The value of a key in NumPy's header: {'descr': '<u2', 'fortran_order': False, 'shape': (480, 848), }
std::string_view npy_value(std::string_view header, std::string_view key, const std::string& source) {
  const std::size_t found = header.find(fmt::format("'{}':", key));
  if (found == std::string_view::npos)
    throw damaged_image(source, fmt::format("its header states no {}", key));
  std::string_view value = header.substr(found + key.size() + 3);
  value.remove_prefix(std::min(value.find_first_not_of(' '), value.size()));
  return value;
}

struct NpyShape {
  int width = 0;
  int height = 0;
};

NpyShape npy_shape(std::string_view header, const std::string& source) {
  std::string_view text = npy_value(header, "shape", source);
  std::vector<int> sides;
  const std::size_t end = text.find(')');
  if (!text.starts_with('(') || end == std::string_view::npos)
    throw damaged_image(source, "its shape is not a tuple");
  text = text.substr(1, end - 1);
  while (!text.empty()) {
    text.remove_prefix(std::min(text.find_first_of("0123456789"), text.size()));
    int side = 0;
    const auto [rest, failure] = std::from_chars(text.data(), text.data() + text.size(), side);
    if (failure != std::errc{}) break;
    sides.push_back(side);
    text.remove_prefix(static_cast<std::size_t>(rest - text.data()));
  }
  if (sides.size() == 3 && sides.back() == 1) sides.pop_back();
  if (sides.size() != 2)
    throw other_content(source, fmt::format("has {} dimensions, but a depth image has two", sides.size()));
  require_reasonable_size(sides[1], sides[0], max_depth_pixels, source);
  return {sides[1], sides[0]};
}

std::span<const std::byte> npy_header(std::span<const std::byte> file, const std::string& source) {
  constexpr std::size_t version_at = 6;
  constexpr std::size_t length_at = 8;
  if (file.size() < length_at + sizeof(std::uint32_t)) throw damaged_image(source, "it ends early");
  const bool is_long = file[version_at] != std::byte{1};
  std::uint32_t length = 0;
  std::memcpy(&length, &file[length_at], is_long ? sizeof(std::uint32_t) : sizeof(std::uint16_t));
  const std::size_t begin = length_at + (is_long ? sizeof(std::uint32_t) : sizeof(std::uint16_t));
  if (length > file.size() - begin) throw damaged_image(source, "it ends early");
  return file.subspan(begin, length);
}

std::string ending_of(const std::filesystem::path& file) {
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(), [](unsigned char letter) { return std::tolower(letter); });
  return ending;
}

}  // namespace

StoredDepth decode_pgm(std::span<const std::byte> file, const std::string& source) {
  constexpr int most = 65535;
  constexpr int one_byte = 255;
  const std::string_view text = as_text(file);
  if (!text.starts_with("P5")) throw other_content(source, "not a binary PGM (P5)");
  PgmHeader header(text, source);
  const int width = header.number();
  const int height = header.number();
  const int greatest = header.number();
  require_reasonable_size(width, height, max_depth_pixels, source);
  if (greatest <= one_byte || greatest > most)
    throw other_content(source, fmt::format("has grey levels up to {}, but depth needs 16 bits", greatest));
  const auto pixels = file.subspan(std::min(header.pixels_at(), file.size()));
  auto image = pixels_from<std::uint16_t, DepthImage>(pixels, width, height, source);
  for (std::uint16_t& value : image.pixels()) value = static_cast<std::uint16_t>(value << 8 | value >> 8);
  return image;
}

StoredDepth decode_npy(std::span<const std::byte> file, const std::string& source) {
  if (!as_text(file).starts_with("\x93NUMPY")) throw other_content(source, "not a NumPy array");
  const std::span<const std::byte> header = npy_header(file, source);
  const std::string_view text = as_text(header);
  if (npy_value(text, "fortran_order", source).starts_with("True"))
    throw other_content(source, "is stored in columns (fortran_order), but rows are needed");
  const NpyShape shape = npy_shape(text, source);
  const auto pixels = file.subspan(static_cast<std::size_t>(header.data() + header.size() - file.data()));
  const std::string_view type = npy_value(text, "descr", source);
  if (type.starts_with("'<u2'"))
    return pixels_from<std::uint16_t, DepthImage>(pixels, shape.width, shape.height, source);
  if (type.starts_with("'<f4'"))
    return pixels_from<float, Image<float>>(pixels, shape.width, shape.height, source);
  if (type.starts_with("'<f8'"))
    return pixels_from<double, Image<float>>(pixels, shape.width, shape.height, source);
  throw other_content(source, "has values of type " + printable(type.substr(0, type.find(','))));
}

std::vector<std::filesystem::path> depth_files(const std::filesystem::path& folder) {
  for (const auto& endings :
       {std::vector<std::string_view>{".png"}, {".tif", ".tiff"}, {".pgm"}, {".npy"}, {".exr"}}) {
    std::vector<std::filesystem::path> files = image_files(folder, endings);
    if (!files.empty()) return files;
  }
  return {};
}

DepthImage read_depth_file(const std::filesystem::path& file, double unit_m) {
  const std::string ending = ending_of(file);
  if (ending == ".png") return read_depth(file);
  const std::vector<std::byte> bytes = read_file(file);
  const std::string source = printable(file);
  const StoredDepth stored = ending == ".npy"   ? decode_npy(bytes, source)
                             : ending == ".pgm" ? decode_pgm(bytes, source)
                             : ending == ".exr" ? decode_exr(bytes, source)
                                                : decode_tiff(bytes, source);
  if (const auto* units = std::get_if<DepthImage>(&stored)) return *units;
  return depth_from_metres(std::get<Image<float>>(stored), unit_m);
}

}  // namespace rva
