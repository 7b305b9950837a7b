#include "capture/mcap/mcap_export.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

#include "capture/capture.hpp"
#include "capture/folder/capture_writer.hpp"
#include "capture/memory_capture.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/random.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

constexpr int width = 40;
constexpr int height = 30;
constexpr std::size_t frames = 5;

template <typename Picture>
Picture noise(Random& random, int columns, int rows, double most) {
  Picture picture(columns, rows);
  for (auto& value : picture.pixels())
    value = static_cast<typename Picture::Value>(random.uniform(0.0, most));
  return picture;
}

ColorImage color_noise(Random& random) {
  ColorImage picture(width / 2, height / 2);
  const auto level = [&] { return static_cast<std::uint8_t>(random.uniform(0.0, 255.9)); };
  for (Rgb& pixel : picture.pixels()) pixel = {level(), level(), level()};
  return picture;
}

CaptureInfo info_in(double unit_m) {
  CaptureInfo info;
  info.depth = {width, height, 38.1, 37.7, 19.3, 14.9, Distortion::none, {}};
  info.depth_unit_m = unit_m;
  info.color = Intrinsics{
      width / 2, height / 2, 20.5, 20.5, 9.5, 7.5, Distortion::inverse_brown_conrady, {0.1, -0.2, 0, 0, 0.3}};
  info.color_from_depth = Transform(Eigen::Translation3d(0.015, 0.0, -0.001) *
                                    Eigen::AngleAxisd(0.01, Eigen::Vector3d(1, 2, 3).normalized()));
  info.pose = Pose{"bay-3", 1.5, -18.2, Transform(Eigen::Translation3d(0.1, 0.2, 0.3))};
  info.camera = CameraInfo{.model = "Intel RealSense D435", .serial = "123", .baseline_m = 0.05};
  info.captured_at = "2026-01-01T00:00:00.250Z";
  return info;
}

FrameMetadata metadata(std::size_t i) {
  FrameMetadata stated;
  stated.counter = 100 + 2 * i;
  stated.time_s = 1000.0 + 0.0333333 * static_cast<double>(i);
  stated.exposure_us = 8500.5;
  stated.temperature_c = 31.0 / 3.0;
  return stated;
}

class McapExport : public testing::Test {
 protected:
  // A capture folder with images of every kind.
  std::unique_ptr<Capture> capture(double unit_m) {
    Random random(7);
    const std::filesystem::path folder = folder_.path() / "capture";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directory(folder);
    CaptureWriter writer(folder, info_in(unit_m));
    for (std::size_t i = 0; i < frames; ++i) {
      writer.write_metadata(i, metadata(i));
      writer.write_depth(i, noise<DepthImage>(random, width, height, 65000.0));
      if (i != 2) writer.write_color(i, color_noise(random));
    }
    for (const Imager imager : both_imagers) {
      writer.write_infrared(imager, Light::projector, noise<FineGrayImage>(random, width, height, 65280.0),
                            {256.0, 5, 8500.0, 16.0, 150.0});
    }
    writer.write_infrared(Imager::left, Light::lamp, noise<FineGrayImage>(random, width, height, 65280.0),
                          {256.0, 4, 4000.0, {}, 0.0});
    return open_capture(folder);
  }

  std::filesystem::path exported(const Capture& capture) {
    const std::filesystem::path file = folder_.path() / "capture.mcap";
    notes_ = write_mcap(capture, file, {});
    return file;
  }

  test::TemporaryFolder folder_;
  std::vector<std::string> notes_;
};

void expect_same_description(const CaptureInfo& read, const CaptureInfo& written) {
  EXPECT_EQ(read.depth, written.depth);
  EXPECT_EQ(read.depth_unit_m, written.depth_unit_m);
  EXPECT_EQ(read.unit_is_assumed, written.unit_is_assumed);
  EXPECT_EQ(read.color, written.color);
  EXPECT_TRUE(read.color_from_depth->isApprox(*written.color_from_depth, 1e-12));
  EXPECT_EQ(read.pose->base, written.pose->base);
  EXPECT_TRUE(read.pose->world_from_camera->isApprox(*written.pose->world_from_camera, 1e-12));
  EXPECT_EQ(read.camera->serial, written.camera->serial);
  EXPECT_EQ(read.infrared, written.infrared);
  EXPECT_EQ(read.lamp, written.lamp);
  EXPECT_EQ(read.captured_at, written.captured_at);
}

void expect_same_frames(const Capture& read, const Capture& written) {
  ASSERT_EQ(read.depth_frames(), written.depth_frames());
  EXPECT_EQ(read.color_frames(), written.color_frames());
  for (std::size_t i = 0; i < written.depth_frames(); ++i) {
    EXPECT_EQ(read.depth(i), written.depth(i)) << i;
    EXPECT_EQ(read.color_of(i), written.color_of(i)) << i;
    EXPECT_EQ(read.metadata_of(i), written.metadata_of(i)) << i;
    for (const Imager imager : both_imagers)
      EXPECT_EQ(read.infrared_of(i, imager), written.infrared_of(i, imager)) << i;
  }
  for (const Imager imager : both_imagers) {
    for (const Light light : {Light::projector, Light::lamp}) {
      EXPECT_EQ(read.has_infrared(imager, light), written.has_infrared(imager, light));
      EXPECT_EQ(read.infrared_mean(imager, light), written.infrared_mean(imager, light));
    }
  }
}

TEST_F(McapExport, IsReadBackExactlyInAnyUnit) {
  for (const double unit_m : {0.001, 0.0001, 0.00025, 1.0 / 5000.0}) {
    const auto written = capture(unit_m);
    const auto read = open_capture(exported(*written));
    EXPECT_EQ(read->info().format, "mcap");
    EXPECT_TRUE(notes_.empty());
    expect_same_description(read->info(), written->info());
    expect_same_frames(*read, *written);
  }
}

TEST_F(McapExport, ExportsItsOwnExportsTheSame) {
  const auto first = open_capture(exported(*capture(0.0001)));
  const std::filesystem::path again = folder_.path() / "again.mcap";
  EXPECT_TRUE(write_mcap(*first, again, {}).empty());
  const auto second = open_capture(again);
  expect_same_description(second->info(), first->info());
  expect_same_frames(*second, *first);
}

TEST_F(McapExport, KeepsAnInfraredImageOfEachFrame) {
  Random random(3);
  std::vector<MemoryFrame> stack(frames);
  for (std::size_t i = 0; i < frames; ++i) {
    stack[i].depth = noise<DepthImage>(random, width, height, 65000.0);
    for (const Imager imager : both_imagers)
      stack[i].infrared[imager] = noise<FineGrayImage>(random, width, height, 65280.0);
  }
  const MemoryCapture written(info_in(0.001), stack);
  const auto read = open_capture(exported(written));
  for (std::size_t i = 0; i < frames; ++i) {
    for (const Imager imager : both_imagers)
      EXPECT_EQ(read->infrared_of(i, imager), written.infrared_of(i, imager));
  }
}

TEST_F(McapExport, ReportsColorImagesWithoutDepth) {
  const auto written = capture(0.001);
  const std::filesystem::path color = folder_.path() / "capture" / "color";
  std::filesystem::copy_file(color / "000001.png", color / "000017.png");
  static_cast<void>(exported(*open_capture(folder_.path() / "capture")));
  EXPECT_THAT(notes_, testing::ElementsAre(testing::HasSubstr("1 colour image(s)")));
}

// Whatever is cut off, the frames that are there are those that were written: also those of the chunk that is
// cut, of which each complete block of its compression is read.
TEST_F(McapExport, IsReadAsFarAsItGoesWhereItIsCut) {
  constexpr int large = 480;
  CaptureInfo info = info_in(0.001);
  info.depth = {large, large, 400.0, 400.0, 239.5, 239.5, Distortion::none, {}};
  Random random(5);
  std::vector<MemoryFrame> stack(frames);
  for (MemoryFrame& frame : stack) frame.depth = noise<DepthImage>(random, large, large, 65000.0);
  const MemoryCapture written(info, stack);
  const std::vector<std::byte> whole = read_file(exported(written));
  const std::filesystem::path file = folder_.path() / "cut.mcap";
  std::vector<std::size_t> counts;
  for (std::size_t length = 0; length <= whole.size(); length += whole.size() / 97) {
    write_file(file, std::span(whole).first(length));
    counts.push_back(0);
    std::unique_ptr<Capture> read;
    try {
      read = open_capture(file);
    } catch (const Error&) {  // no frame is complete yet
      continue;
    }
    counts.back() = read->depth_frames();
    ASSERT_GT(counts.back(), 0U);
    for (std::size_t i = 0; i < counts.back(); ++i) ASSERT_EQ(read->depth(i), written.depth(i)) << length;
  }
  EXPECT_TRUE(std::ranges::is_sorted(counts));
  for (std::size_t count = 0; count <= frames; ++count)
    EXPECT_TRUE(std::ranges::binary_search(counts, count)) << count << " frames are never read alone";
}

TEST_F(McapExport, RefusesAFolderThatCannotBeWritten) {
  EXPECT_THROW(static_cast<void>(write_mcap(*capture(0.001), folder_.path() / "none" / "x.mcap", {})), Error);
}

}  // namespace
}  // namespace rva
