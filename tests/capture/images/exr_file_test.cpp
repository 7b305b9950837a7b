#include <ImfChannelList.h>
#include <ImfFrameBuffer.h>
#include <ImfHeader.h>
#include <ImfOutputFile.h>
#include <ImfTileDescription.h>
#include <ImfTiledOutputFile.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "capture/images/depth_file.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

constexpr int width = 7;
constexpr int height = 5;

Image<float> ramp(float from) {
  Image<float> image(width, height);
  for (std::size_t i = 0; i < image.size(); ++i) image[i] = from + 0.125F * static_cast<float>(i);
  return image;
}

class ExrFile : public testing::Test {
 protected:
  // Channel k has values from 10 k upwards.
  std::vector<std::byte> file_with(const std::vector<std::string>& channels) {
    Imf::Header header(Imath::Box2i({0, 0}, {width - 1, height - 1}), Imath::Box2i({3, -2}, {9, 2}));
    Imf::FrameBuffer frame;
    std::vector<Image<float>> images;
    images.reserve(channels.size());
    for (const std::string& name : channels) {
      header.channels().insert(name, Imf::Channel(Imf::FLOAT));
      images.push_back(ramp(10.0F * static_cast<float>(images.size())));
      frame.insert(name, Imf::Slice::Make(Imf::FLOAT, images.back().data(), header.dataWindow()));
    }
    const std::string path = (folder_.path() / "image.exr").string();
    {
      Imf::OutputFile file(path.c_str(), header);
      file.setFrameBuffer(frame);
      file.writePixels(height);
    }
    return read_file(path);
  }

  static Image<float> decoded(std::span<const std::byte> file) { return decode_exr(file, "image.exr"); }

  test::TemporaryFolder folder_;
};

TEST_F(ExrFile, IsReadExactlyWhereverItsWindowLies) { EXPECT_EQ(decoded(file_with({"Y"})), ramp(0)); }

TEST_F(ExrFile, GivesTheChannelOfDepth) {
  EXPECT_EQ(decoded(file_with({"R", "Z"})), ramp(10));
  EXPECT_EQ(decoded(file_with({"B", "G", "R", "View.Depth.Z"})), ramp(30));
  EXPECT_EQ(decoded(file_with({"A", "depth"})), ramp(10));
  EXPECT_EQ(decoded(file_with({"anything"})), ramp(0));
}

TEST_F(ExrFile, IsRefusedWithoutDepth) {
  EXPECT_THROW(static_cast<void>(decoded(file_with({"B", "G", "R"}))), Error);
}

TEST_F(ExrFile, IsRefusedWhereItIsCut) {
  const std::vector<std::byte> whole = file_with({"Z"});
  for (std::size_t length = 0; length < whole.size(); length += 7)
    EXPECT_THROW(static_cast<void>(decoded(std::span(whole).first(length))), Error) << length;
}

std::vector<std::byte> with_replaced(std::vector<std::byte> file, std::string_view from,
                                     std::string_view to) {
  const std::span<const std::byte> wanted = std::as_bytes(std::span(from));
  const auto found = std::ranges::search(file, wanted);
  EXPECT_FALSE(found.empty());
  std::ranges::copy(std::as_bytes(std::span(to)), found.begin());
  return file;
}

// OpenEXR reads whole floats and then goes on with the bytes left over as the next attribute's name.
TEST_F(ExrFile, IsRefusedWithAPartOfAFloatInAList) {
  using namespace std::string_literals;
  const std::vector<std::byte> file =
      with_replaced(file_with({"Z"}), "screenWindowCenter\0v2f\0\x08\0\0\0\0\0\0\0\0\0\0\0"s,
                    "screenWind\0floatvector\0\x07\0\0\0\0\0\0\0\0\0\0"s);
  try {
    static_cast<void>(decoded(file));
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("'floatvector' that is not supported, or damaged"),
              std::string::npos)
        << error.what();
  }
}

TEST_F(ExrFile, IsRefusedWithTilesThatNeedTooMuchMemory) {
  Imf::Header header(4, 4);
  header.setTileDescription(Imf::TileDescription(16384, 16384));
  header.channels().insert("Z", Imf::Channel(Imf::FLOAT));
  const std::string path = (folder_.path() / "tiles.exr").string();
  { const Imf::TiledOutputFile file(path.c_str(), header); }
  try {
    static_cast<void>(decoded(read_file(path)));
    FAIL() << "accepted";
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("blocks of pixels that are too large"), std::string::npos)
        << error.what();
  }
}

}  // namespace
}  // namespace rva
