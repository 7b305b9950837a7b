#include <ImathBox.h>
#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfIO.h>
#include <ImfInputFile.h>

#include <algorithm>
#include <array>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>

#include "capture/images/depth_file.hpp"
#include "core/error.hpp"
#include "depth/image_file.hpp"

namespace rva {
namespace {

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
  try {
    Bytes bytes(file, source);
    Imf::InputFile opened(bytes, 0);
    return read(opened, source);
  } catch (const Error&) {
    throw;
  } catch (const std::exception& failure) {
    throw damaged_image(source, failure.what());
  }
}

}  // namespace rva
