#include "capture/capture.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <tuple>

#include "capture/formats.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "depth/image_file.hpp"
#include "tests/temporary_folder.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

using Json = nlohmann::json;

const Json full_description = Json::parse(R"({
  "format": "rva-capture", "version": 1, "site": {"aircraft": "unknown to us"},
  "depth": {"width": 8, "height": 6, "fx": 4.25, "fy": 4.5, "cx": 3.5, "cy": 2.5,
            "distortion_model": "brown_conrady", "distortion": [0.1, 0, 0, 0, 0], "unit_m": 0.0001},
  "color": {"width": 4, "height": 3, "fx": 2, "fy": 2, "cx": 1.5, "cy": 1},
  "color_from_depth": [1,0,0,0.015, 0,1,0,0, 0,0,1,0, 0,0,0,1],
  "pose": {"base": "b1", "pan_deg": 1.5, "tilt_deg": -18, "world_from_camera": [1,0,0,1, 0,1,0,2, 0,0,1,3, 0,0,0,1]},
  "camera": {"model": "Intel RealSense D435", "serial": "123", "baseline_m": 0.05},
  "captured_at": "2026-01-01T00:00:00Z"})");

TEST(CaptureJson, ReadsEveryField) {
  const CaptureInfo info = parse_capture_json(full_description.dump(), "capture.json");
  EXPECT_EQ(info.depth,
            (Intrinsics{8, 6, 4.25, 4.5, 3.5, 2.5, Distortion::brown_conrady, {0.1, 0, 0, 0, 0}}));
  EXPECT_EQ(info.depth_unit_m, 0.0001);
  EXPECT_EQ(info.color->width, 4);
  EXPECT_EQ(info.color_from_depth->translation().x(), 0.015);
  EXPECT_EQ(info.pose->base, "b1");
  EXPECT_EQ(info.pose->tilt_deg, -18.0);
  EXPECT_EQ(info.pose->world_from_camera->translation(), Eigen::Vector3d(1, 2, 3));
  EXPECT_EQ(info.camera->baseline_m, 0.05);
  EXPECT_EQ(info.captured_at, "2026-01-01T00:00:00Z");
  EXPECT_EQ(Json::parse(info.source_json), full_description);  // keys unknown to us are kept
}

TEST(CaptureJson, NeedsOnlyTheDepthCamera) {
  Json minimal;
  for (const char* key : {"format", "version", "depth"}) minimal[key] = full_description[key];
  const CaptureInfo info = parse_capture_json(minimal.dump(), "capture.json");
  EXPECT_FALSE(info.color || info.color_from_depth || info.pose || info.camera);
}

TEST(CaptureJson, NamesTheFieldThatIsWrong) {
  const std::vector<std::tuple<const char*, Json, const char*>> cases{
      {"/format", "other", "format"},
      {"/version", 2, "version 2"},
      {"/depth", nullptr, "depth: missing"},
      {"/depth/fx", -1, "depth.fx"},
      {"/depth/width", 8.5, "depth.width"},
      {"/depth/unit_m", "mm", "depth.unit_m"},
      {"/depth/cx", nullptr, "depth.cx"},
      {"/depth/distortion_model", "fisheye", "fisheye"},
      {"/depth/distortion", Json::array({1}), "depth.distortion"},
      {"/color/height", 0, "color.height"},
      {"/color_from_depth/0", 2, "color_from_depth"},
      {"/pose/pan_deg", "left", "pose.pan_deg"},
      {"/camera", 3, "camera"},
  };
  for (const auto& [pointer, value, expected] : cases) {
    Json broken = full_description;
    broken[Json::json_pointer(pointer)] = value;
    try {
      static_cast<void>(parse_capture_json(broken.dump(), "capture.json"));
      FAIL() << pointer;
    } catch (const Error& error) {
      EXPECT_THAT(error.what(),
                  testing::AllOf(testing::HasSubstr("capture.json"), testing::HasSubstr(expected)));
    }
  }
}

TEST(Open3dJson, ReadsTheMatrixColumnByColumn) {
  const CaptureInfo info = parse_open3d_json(
      R"({"width": 640, "height": 480, "intrinsic_matrix": [610, 0, 0, 0, 611, 0, 320, 240, 1],
          "depth_scale": 10000.0, "device_name": "D435", "serial_number": "7"})",
      "intrinsic.json");
  EXPECT_EQ(info.depth, (Intrinsics{640, 480, 610, 611, 320, 240}));
  EXPECT_EQ(info.color, info.depth);
  EXPECT_TRUE(info.color_from_depth->isApprox(Transform::Identity()));
  EXPECT_DOUBLE_EQ(info.depth_unit_m, 0.0001);
  EXPECT_EQ(info.camera->serial, "7");
}

TEST(Open3dJson, MillimetresUnlessItSaysOtherwise) {
  const std::string text = R"({"width": 2, "height": 2, "intrinsic_matrix": [1, 0, 0, 0, 1, 0, 0, 0, 1])";
  EXPECT_DOUBLE_EQ(parse_open3d_json(text + "}", "i").depth_unit_m, 0.001);
  EXPECT_THROW(static_cast<void>(parse_open3d_json(text + R"(, "depth_scale": 0})", "i")), Error);
}

TEST(TumList, SkipsCommentsAndNamesBadLines) {
  const auto entries = parse_tum_list("# time file\n1.5 depth/a.png\n\n2 depth/b.png\r\n", "depth.txt");
  ASSERT_EQ(entries.size(), 2U);
  EXPECT_EQ(entries[0].time_s, 1.5);
  EXPECT_EQ(entries[1].file, "depth/b.png");
  try {
    static_cast<void>(parse_tum_list("1 a.png\nsoon b.png\n", "depth.txt"));
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(error.source(), "depth.txt:2");
  }
}

class Folder : public testing::Test {
 protected:
  void write_frames(const char* subfolder, int count, int width = 8, int height = 6) {
    fs::create_directories(folder_ / subfolder);
    for (int k = 0; k < count; ++k) {
      write_file(folder_ / subfolder / fmt::format("{:06}.png", k),
                 encode_png(DepthImage(width, height, static_cast<std::uint16_t>(100 + k))));
    }
  }
  test::TemporaryFolder folder_;
};

TEST_F(Folder, FramesComeInTheOrderOfTheirNames) {
  write_file(folder_ / "capture.json", full_description.dump());
  write_frames("depth", 12);
  write_file(folder_ / "depth" / "notes.txt", "not a frame");
  const auto capture = open_capture(folder_.path());
  ASSERT_EQ(capture->depth_frames(), 12U);
  for (std::size_t k = 0; k < 12; ++k) EXPECT_EQ(capture->depth(k)[0], 100 + k);
  EXPECT_EQ(capture->color_frames(), 0U);
}

TEST_F(Folder, TumTakesItsListAndTheOptionsIntrinsics) {
  write_frames("depth", 3);
  fs::create_directories(folder_ / "rgb");
  for (const char* name : {"early.png", "near.png"})
    write_file(folder_ / "rgb" / name, encode_png(ColorImage(8, 6)));
  write_file(folder_ / "depth.txt", "# depth\n10.0 depth/000002.png\n11.0 depth/000000.png\n");
  write_file(folder_ / "rgb.txt", "9.0 rgb/early.png\n10.1 rgb/near.png\n");
  EXPECT_THROW(static_cast<void>(open_capture(folder_.path())), Error);
  CaptureOptions options;
  options.intrinsics = Intrinsics{1, 1, 7, 7, 3.5, 2.5};
  const auto capture = open_capture(folder_.path(), options);
  EXPECT_EQ(capture->info().depth.width, 8);
  EXPECT_EQ(capture->info().depth_unit_m, 1.0 / 5000.0);
  ASSERT_EQ(capture->depth_frames(), 2U);
  EXPECT_EQ(capture->depth(0)[0], 102);
  EXPECT_EQ(capture->color_frames(), 1U);
}

TEST_F(Folder, TumDoesNotLeaveItsFolder) {
  CaptureOptions options;
  options.intrinsics = Intrinsics{1, 1, 525, 525, 319.5, 239.5};
  for (const char* file : {"../outside.png", "/etc/passwd", "depth/../../outside.png"}) {
    write_file(folder_ / "depth.txt", fmt::format("1.0 {}\n", file));
    EXPECT_THROW(static_cast<void>(open_capture(folder_.path(), options)), Error) << file;
  }
}

TEST_F(Folder, EveryFrameHasTheStatedSize) {
  write_file(folder_ / "capture.json", full_description.dump());
  write_frames("depth", 2);
  write_file(folder_ / "depth" / "000001.png", encode_png(DepthImage(8, 5)));
  const auto capture = open_capture(folder_.path());
  EXPECT_NO_THROW(static_cast<void>(capture->depth(0)));
  EXPECT_THROW(static_cast<void>(capture->depth(1)), Error);
}

TEST_F(Folder, WithoutFramesIsNoCapture) {
  EXPECT_THROW(static_cast<void>(open_capture(folder_.path())), Error);
  EXPECT_THROW(static_cast<void>(open_capture(folder_ / "none")), Error);
  write_file(folder_ / "capture.json", full_description.dump());
  EXPECT_THROW(static_cast<void>(open_capture(folder_.path())), Error);
  EXPECT_THROW(static_cast<void>(open_capture(folder_ / "capture.json")), Error);
}

}  // namespace
}  // namespace rva
