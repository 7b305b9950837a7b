#include "capture/folder/capture_writer.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <thread>

#include "capture/formats.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json_object.hpp"
#include "core/output_folder.hpp"
#include "depth/image_file.hpp"
#include "tests/depth/stacks.hpp"
#include "tests/temporary_folder.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

using Json = nlohmann::json;

Transform odd_transform() {
  Transform a_from_b(Eigen::Translation3d(0.1, -1.0 / 3.0, 2e-5));
  a_from_b.rotate(Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()));
  return a_from_b;
}

CaptureInfo full_info() {
  CaptureInfo info;
  info.depth = {8, 6, 4.1 / 3.0, 4.5 / 3.0, 3.5, 2.5, Distortion::brown_conrady, {0.1, -0.2, 1e-9, 0, 0.3}};
  info.depth_unit_m = 0.0001;
  info.color = Intrinsics{4, 3, 2, 2, 1.5, 1};
  info.color_from_depth = odd_transform();
  info.pose = Pose{"b1", 1.5, -18.2, odd_transform()};
  info.camera = CameraInfo{"Intel RealSense D435", "123", 0.05};
  info.lamp = InfraredBurst{256.0, 5, 4000.0, {}, 0.0};
  info.infrared = InfraredBurst{256.0, 10, 8500.0, 16.0, 150.0};
  info.captured_at = "2026-01-01T00:00:00Z";
  return info;
}

std::string text_of(const CaptureInfo& info, const std::string& extra_json_object = "{}") {
  return json_text(json_of(info, extra_json_object));
}

CaptureInfo read_back(const std::string& text) { return parse_capture_json(text, "capture.json"); }

void expect_near(const std::optional<Transform>& a, const std::optional<Transform>& b) {
  ASSERT_EQ(a.has_value(), b.has_value());
  EXPECT_TRUE(!a || a->isApprox(*b, 1e-12));
}

void expect_same(const CaptureInfo& a, const CaptureInfo& b) {
  EXPECT_EQ(a.depth, b.depth);
  EXPECT_EQ(a.depth_unit_m, b.depth_unit_m);
  EXPECT_EQ(a.color, b.color);
  EXPECT_EQ(a.infrared, b.infrared);
  EXPECT_EQ(a.lamp, b.lamp);
  expect_near(a.color_from_depth, b.color_from_depth);
  ASSERT_EQ(a.pose.has_value(), b.pose.has_value());
  if (a.pose) {
    EXPECT_EQ(a.pose->base, b.pose->base);
    EXPECT_EQ(a.pose->pan_deg, b.pose->pan_deg);
    EXPECT_EQ(a.pose->tilt_deg, b.pose->tilt_deg);
    expect_near(a.pose->world_from_camera, b.pose->world_from_camera);
  }
  ASSERT_EQ(a.camera.has_value(), b.camera.has_value());
  if (a.camera) {
    EXPECT_EQ(a.camera->model, b.camera->model);
    EXPECT_EQ(a.camera->serial, b.camera->serial);
    EXPECT_EQ(a.camera->baseline_m, b.camera->baseline_m);
  }
  EXPECT_EQ(a.captured_at, b.captured_at);
}

TEST(CaptureJsonWriting, IsReadBackTheSame) {
  CaptureInfo sparse = full_info();
  sparse.color.reset();
  sparse.pose = Pose{{}, {}, -18.0, {}};
  sparse.camera = CameraInfo{"", "7", {}};
  CaptureInfo empty_parts = full_info();
  empty_parts.pose = Pose{};
  empty_parts.camera = CameraInfo{};
  for (const CaptureInfo& info : {full_info(), sparse, empty_parts, test::info_of(8, 6)})
    expect_same(read_back(text_of(info)), info);
}

TEST(CaptureJsonWriting, ContainsOnlyWhatIsKnown) {
  const Json document = Json::parse(text_of(test::info_of(8, 6)));
  EXPECT_EQ(document.size(), 3U) << document;  // format, version, depth
}

TEST(CaptureJsonWriting, KeepsKeysThatTheFormatDoesNotDefine) {
  const Json extra = Json::parse(R"({"site": {"bay": 3}, "depth": {"exposure_us": 8500}, "empty": null})");
  const std::string text = text_of(full_info(), extra.dump());
  const Json document = Json::parse(text);
  EXPECT_EQ(document["site"], extra["site"]);
  EXPECT_EQ(document["depth"]["exposure_us"], 8500);
  EXPECT_TRUE(document.contains("empty"));
  expect_same(read_back(text), full_info());
}

TEST(CaptureJsonWriting, TakesItsOwnKeysFromTheInfoAlone) {
  const std::string earlier = text_of(full_info(), R"({"site": "here"})");
  const CaptureInfo info = test::info_of(8, 6);
  const std::string text = text_of(info, earlier);
  expect_same(read_back(text), info);
  EXPECT_EQ(Json::parse(text).size(), 4U) << text;
  expect_same(read_back(text_of(info, R"({"format": "x", "version": 9, "depth": 1, "pose": 2})")), info);
}

TEST(CaptureJsonWriting, IsTheSameAfterEveryRound) {
  const std::string once = text_of(full_info(), R"({"site": "here", "depth": {"gain": 16}})");
  EXPECT_EQ(Json::parse(text_of(full_info(), once)), Json::parse(once));
}

TEST(CaptureJsonWriting, IsUtf8WhateverTheNameOfTheCamera) {
  CaptureInfo info = full_info();
  info.camera->model = "D435\xFF\n";
  EXPECT_EQ(read_back(text_of(info)).camera->model, "D435\xEF\xBF\xBD\n");
}

TEST(CaptureJsonWriting, RefusesExtraKeysThatAreNoObject) {
  for (const char* extra : {"", "[]", "3", "{", "\xFF"})
    EXPECT_THROW(static_cast<void>(text_of(full_info(), extra)), Error) << extra;
}

class Writer : public testing::Test {
 protected:
  test::TemporaryFolder folder_;
};

TEST_F(Writer, FramesAreReadBackTheSame) {
  std::mt19937 random(1);
  const std::vector<DepthImage> frames = test::random_stack({8, 6, 12}, 5000, 3000, 0.2, random);
  const ColorImage color(4, 3, Rgb{1, 2, 3});
  CaptureWriter writer(folder_.path(), full_info());
  for (std::size_t k = 0; k < frames.size(); ++k) writer.write_depth(k, frames[k]);
  writer.write_color(0, color);
  const auto capture = open_capture(folder_.path());
  CaptureInfo without_infrared = full_info();
  without_infrared.infrared = without_infrared.lamp = std::nullopt;
  expect_same(capture->info(), without_infrared);
  ASSERT_EQ(capture->depth_frames(), frames.size());
  for (std::size_t k = 0; k < frames.size(); ++k) EXPECT_EQ(capture->depth(k), frames[k]) << k;
  ASSERT_EQ(capture->color_frames(), 1U);
  EXPECT_EQ(capture->color(0), color);
}

TEST_F(Writer, FramesMayComeFromSeveralThreads) {
  CaptureWriter writer(folder_.path(), test::info_of(8, 6));
  std::vector<std::jthread> threads;
  for (std::size_t k = 0; k < 8; ++k)
    threads.emplace_back([&writer, k] { writer.write_depth(k, DepthImage(8, 6, std::uint16_t(100 + k))); });
  threads.clear();
  const auto capture = open_capture(folder_.path());
  ASSERT_EQ(capture->depth_frames(), 8U);
  for (std::size_t k = 0; k < 8; ++k) EXPECT_EQ(capture->depth(k)[0], 100 + k);
}

TEST_F(Writer, InfraredMeansAreReadBackWithTheirFractions) {
  CaptureWriter writer(folder_.path(), full_info());
  writer.write_depth(0, DepthImage(8, 6, 500));
  writer.write_depth(1, DepthImage(8, 6, 500));
  FineGrayImage mean(8, 6, 2 * 256 + 77);
  mean[5] = 255 * 256;
  writer.write_infrared(Imager::left, Light::projector, mean, {256.0, 2, 8500.0, 16.0, 150.0});
  writer.write_infrared(Imager::right, Light::projector, FineGrayImage(8, 6, 256), {256.0, 2});
  writer.write_infrared(Imager::left, Light::lamp, FineGrayImage(8, 6, 128), {256.0, 3, {}, {}, 0.0});
  const auto capture = open_capture(folder_.path());
  EXPECT_EQ(capture->info().infrared, (InfraredBurst{256.0, 2}));
  EXPECT_EQ(capture->info().lamp, (InfraredBurst{256.0, 3, {}, {}, 0.0}));
  EXPECT_TRUE(capture->has_infrared(Imager::right, Light::projector));
  EXPECT_FALSE(capture->has_infrared(Imager::right, Light::lamp));
  EXPECT_FALSE(capture->infrared_mean(Imager::right, Light::lamp));
  const auto levels = capture->infrared_mean(Imager::left, Light::projector);
  ASSERT_TRUE(levels);
  EXPECT_FLOAT_EQ((*levels)[0], 2.0F + 77.0F / 256.0F);
  EXPECT_FLOAT_EQ((*levels)[5], 255.0F);
  EXPECT_FLOAT_EQ((*capture->infrared_mean(Imager::left, Light::lamp))[0], 0.5F);
  for (std::size_t frame = 0; frame < 2; ++frame)
    EXPECT_EQ(capture->infrared_of(frame, Imager::left), mean) << "the mean of all frames is that of each";
}

TEST_F(Writer, ImagesBesideThoseOfTheFramesDoNotCount) {
  CaptureWriter writer(folder_.path(), full_info());
  writer.write_depth(0, DepthImage(8, 6, 500));
  writer.write_infrared(Imager::left, Light::projector, FineGrayImage(8, 6, 256), {256.0, 1});
  write_file(folder_ / "infrared" / "right.png", encode_png(FineGrayImage(8, 6, 9 * 256)));
  const auto mean = open_capture(folder_.path())->infrared_mean(Imager::left, Light::projector);
  EXPECT_FLOAT_EQ((*mean)[0], 1.0F);
}

TEST_F(Writer, RefusesFramesOfAnotherSize) {
  CaptureWriter writer(folder_.path(), full_info());
  EXPECT_THROW(writer.write_infrared(Imager::left, Light::lamp, FineGrayImage(6, 8), {}), Error);
  EXPECT_THROW(writer.write_depth(0, DepthImage(6, 8)), Error);
  EXPECT_THROW(writer.write_depth(0, DepthImage()), Error);
  EXPECT_THROW(writer.write_color(0, ColorImage(8, 6)), Error);
  EXPECT_FALSE(fs::exists(folder_ / "depth" / "000000.png"));
}

TEST_F(Writer, RefusesWhatCouldNotBeReadBack) {
  std::vector<CaptureInfo> impossible(6, full_info());
  impossible[0].depth.fx = 0.0;
  impossible[1].depth.cx = std::nan("");
  impossible[2].depth_unit_m = 0.0;
  impossible[3].depth.width = impossible[3].depth.height = 100000;
  impossible[4].camera->baseline_m = -0.05;
  impossible[5].pose->world_from_camera->linear() *= 2.0;
  for (const CaptureInfo& info : impossible) {
    EXPECT_THROW(CaptureWriter(folder_.path(), info), Error);
    EXPECT_TRUE(fs::is_empty(folder_.path()));
  }
}

TEST_F(Writer, NamesTheFileThatCannotBeWritten) {
  EXPECT_THROW(CaptureWriter(folder_ / "none", full_info()), Error);
  CaptureWriter writer(folder_.path(), full_info());
  write_file(folder_ / "depth", "in the way");
  try {
    writer.write_depth(3, DepthImage(8, 6));
    FAIL();
  } catch (const Error& error) {
    EXPECT_THAT(error.source(), testing::EndsWith("depth/000003.png"));
  }
}

TEST_F(Writer, AnEarlierCaptureIsReplacedAndNothingElse) {
  const fs::path target = folder_ / "capture";
  const auto record = [&](std::size_t frames) {
    OutputFolder out(target, capture_files(), Existing::replace);
    CaptureWriter writer(out.path("."), full_info());
    for (std::size_t k = 0; k < frames; ++k) writer.write_depth(k, DepthImage(8, 6));
    writer.write_color(0, ColorImage(4, 3));
    out.commit();
  };
  record(3);
  record(2);
  EXPECT_EQ(open_capture(target)->depth_frames(), 2U);
  write_file(target / "depth" / "notes.txt", "mine");
  EXPECT_THROW(record(1), Error);
  EXPECT_EQ(open_capture(target)->depth_frames(), 2U);
}

}  // namespace
}  // namespace rva
