#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>

#include "capture/images/depth_file.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"
#include "depth/image_file.hpp"

namespace rva {
namespace {

constexpr int most_side_px = 1 << 15;  // of an image or a tile

/// The bytes of a file as OpenEXR reads them.
class Bytes : public Imf::IStream {
 public:
  Bytes(std::span<const std::byte> bytes, const std::string& source)
      : IStream(source.c_str()), bytes_(bytes) {}

  bool read(char* to, int count) override {
    const auto wanted = static_cast<std::size_t>(count);
    if (count < 0 || at_ > bytes_.size() || wanted > bytes_.size() - at_)
      throw std::runtime_error("it ends early");
    std::memcpy(to, bytes_.data() + at_, wanted);
    at_ += wanted;
    return at_ < bytes_.size();
  }
  std::uint64_t tellg() override { return at_; }
  void seekg(std::uint64_t at) override { at_ = static_cast<std::size_t>(at); }

 private:
  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
};

/// Attribute types that OpenEXR reads without regard to the stated size, with their sizes.
struct FixedType {
  std::string_view name;
  std::size_t bytes;
};
constexpr std::array fixed_types{
    FixedType{"box2f", 16},      FixedType{"box2i", 16},   FixedType{"chromaticities", 32},
    FixedType{"compression", 1}, FixedType{"double", 8},   FixedType{"envmap", 1},
    FixedType{"float", 4},       FixedType{"int", 4},      FixedType{"keycode", 28},
    FixedType{"lineOrder", 1},   FixedType{"m33d", 72},    FixedType{"m33f", 36},
    FixedType{"m44d", 128},      FixedType{"m44f", 64},    FixedType{"rational", 8},
    FixedType{"tiledesc", 9},    FixedType{"timecode", 8}, FixedType{"v2d", 16},
    FixedType{"v2f", 8},         FixedType{"v2i", 8},      FixedType{"v3d", 24},
    FixedType{"v3f", 12},        FixedType{"v3i", 12}};

/// Checks the header of a file before OpenEXR reads it: OpenEXR allocates as much memory for an attribute as
/// the file states, and a damaged file may state more than it has.
class HeaderCheck {
 public:
  HeaderCheck(std::span<const std::byte> file, const std::string& source) : file_(file), source_(source) {}

  /// @throws Error
  void run() {
    constexpr std::uint32_t deep_or_in_parts = 0x1800;  // flags of the version
    static_cast<void>(number());                        // magic
    if ((number() & deep_or_in_parts) != 0)
      throw Error(source_, "has several parts or several values a pixel", "give an image of one part");
    while (!text().empty()) {  // the attribute's name; an empty one ends the header
      const std::string_view type = text();
      const std::uint32_t bytes = number();
      const std::span<const std::byte> value = take(bytes);
      check(type, value);
      measure(type, value);
    }
    if (block_pixels_ * pixel_bytes_ > most_block_bytes)
      throw Error(source_, "has blocks of pixels that are too large",
                  "write the image with fewer channels, or in smaller tiles");
  }

 private:
  std::span<const std::byte> take(std::size_t count) {
    if (count > file_.size() - at_) throw damaged_image(source_, "its header ends early");
    at_ += count;
    return file_.subspan(at_ - count, count);
  }

  std::uint32_t number() {
    std::uint32_t value = 0;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }

  std::string_view text() {
    const std::string_view rest(reinterpret_cast<const char*>(file_.data()) + at_, file_.size() - at_);
    const std::size_t length = rest.find('\0');
    if (length == std::string_view::npos) throw damaged_image(source_, "its header ends early");
    at_ += length + 1;
    return rest.substr(0, length);
  }

  void check(std::string_view type, std::span<const std::byte> value) const {
    const auto* const fixed = std::ranges::find(fixed_types, type, &FixedType::name);
    const bool sound = fixed != fixed_types.end() ? value.size() == fixed->bytes
                       : type == "chlist"         ? is_channel_list(value)
                       : type == "floatvector"    ? value.size() % sizeof(float) == 0
                                                  : type == "string";
    if (!sound)
      throw Error(source_, "has an attribute '" + printable(type) + "' that is not supported, or damaged",
                  "write the image with fewer attributes");
  }

  // Names that end in a zero, each followed by 16 bytes; an empty name at the end.
  static bool is_channel_list(std::span<const std::byte> value) {
    for (std::size_t at = 0; at < value.size();) {
      const auto rest = value.subspan(at);
      const auto length = static_cast<std::size_t>(std::ranges::find(rest, std::byte{0}) - rest.begin());
      if (length == 0) return at + 1 == value.size();
      at += length + 1 + channel_bytes;
    }
    return false;
  }

  // OpenEXR allocates a whole tile, or up to 256 whole rows, before it reads any pixel.
  void measure(std::string_view type, std::span<const std::byte> value) {
    const auto number_at = [&](std::size_t at) {
      std::uint32_t number = 0;
      std::memcpy(&number, value.subspan(at, sizeof number).data(), sizeof number);
      return std::uint64_t{number};
    };
    constexpr std::uint64_t rows = 256;
    const auto side = [&](std::uint64_t px) { return std::min(px, std::uint64_t{most_side_px}); };
    if (type == "chlist") pixel_bytes_ = std::max(pixel_bytes_, value.size() / channel_bytes * sizeof(float));
    if (type == "tiledesc") block_pixels_ = std::max(block_pixels_, side(number_at(0)) * side(number_at(4)));
    if (type == "box2i") {
      const auto width = static_cast<std::uint32_t>(number_at(8) - number_at(0) + 1);
      block_pixels_ = std::max(block_pixels_, side(width) * rows);
    }
  }

  static constexpr std::size_t channel_bytes = 16;  // after the channel's name
  static constexpr std::uint64_t most_block_bytes = 128U << 20;

  std::span<const std::byte> file_;
  const std::string& source_;
  std::size_t at_ = 0;
  std::uint64_t block_pixels_ = 0;
  std::uint64_t pixel_bytes_ = 0;
};

// Renderers name the channel of depth Z, or with the names of layers before it; others write one grey
// channel. Empty if there is none of these, and more than one channel.
std::string depth_channel(const Imf::ChannelList& channels) {
  constexpr std::array<std::string_view, 3> names{"Z", "depth", "Depth"};
  constexpr std::array<std::string_view, 3> endings{".Z", ".V", ".z"};
  std::string name;
  int count = 0;
  for (auto channel = channels.begin(); channel != channels.end(); ++channel, ++count) {
    name = channel.name();
    const auto ends = [&](std::string_view ending) { return std::string_view(name).ends_with(ending); };
    if (std::ranges::find(names, name) != names.end() || std::ranges::any_of(endings, ends)) return name;
  }
  if (count == 1) return name;
  return channels.findChannel("Y") != nullptr ? "Y" : "";
}

Image<float> read(Imf::InputFile& file, const std::string& source) {
  const Imath::Box2i window = file.header().dataWindow();
  const long width = long{window.max.x} - window.min.x + 1;
  const long height = long{window.max.y} - window.min.y + 1;
  require_reasonable_size(width, height, max_depth_pixels, source);
  const std::string channel = depth_channel(file.header().channels());
  if (channel.empty())
    throw Error(source, "has several channels, and none of them is named Z or depth",
                "give depth in a channel Z, or in an image of one channel");
  Image<float> depth_m(static_cast<int>(width), static_cast<int>(height));
  Imf::FrameBuffer frame;
  frame.insert(channel, Imf::Slice::Make(Imf::FLOAT, depth_m.data(), window));
  file.setFrameBuffer(frame);
  file.readPixels(window.min.y, window.max.y);
  return depth_m;
}

}  // namespace

Image<float> decode_exr(std::span<const std::byte> file, const std::string& source) {
  Imf::Header::setMaxImageSize(most_side_px, most_side_px);
  Imf::Header::setMaxTileSize(most_side_px, most_side_px);
  HeaderCheck(file, source).run();
  try {
    Bytes bytes(file, source);
    Imf::InputFile opened(bytes, 0);
    return read(opened, source);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& failure) {
    throw damaged_image(source, printable(failure.what()));
  }
}

}  // namespace rva
