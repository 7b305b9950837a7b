#include "evaluate/recorded_study.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "capture/folder/capture_writer.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/random.hpp"
#include "depth/image_file.hpp"
#include "tests/temporary_folder.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

constexpr int width = 160;
constexpr int height = 120;

/// A wall in front of which a box of 20 x 20 pixels was left.
class Recorded : public testing::Test {
 protected:
  Recorded() {
    write_capture("initial", 0, 1);
    write_capture("final", 60, 2);
    Mask label(width, height);
    for (int v = 50; v < 70; ++v) {
      for (int u = 60; u < 80; ++u) label(u, v) = 3;
    }
    write_file(scene_ / "label.png", encode_png(label));
    write_file(scene_ / "seen.png", encode_png(Mask(width, height, mask_set)));
    write_file(scene_ / "truth.json",
               R"({"objects":{"3":{"name":"box","depth_m":0.94},"4":{"name":"hidden"}}})");
    write_file(scene_ / "final_from_initial.txt", "1 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n");
  }

  void write_capture(const std::string& name, int nearer_mm, std::uint64_t seed) {
    fs::create_directories(scene_ / name);
    CaptureInfo info;
    info.depth = {.width = width, .height = height, .fx = 200, .fy = 200, .cx = 79.5, .cy = 59.5};
    info.depth_unit_m = 0.001;
    info.camera = CameraInfo{"Test", "1", 0.05};
    CaptureWriter writer(scene_ / name, info);
    Random random(seed);
    for (std::size_t frame = 0; frame < 4; ++frame) {
      DepthImage depth(width, height);
      for (int v = 0; v < height; ++v) {
        for (int u = 0; u < width; ++u) {
          const bool box = u >= 60 && u < 80 && v >= 50 && v < 70;
          depth(u, v) = static_cast<std::uint16_t>(1000.5 - (box ? nearer_mm : 0) + random.normal());
        }
      }
      writer.write_depth(frame, depth);
    }
  }

  test::TemporaryFolder folder_;
  fs::path scene_ = folder_ / "wall";
};

TEST_F(Recorded, WhatIsThereIsFoundAndNothingElse) {
  const std::vector<RecordedInspection> study = run_recorded_study(folder_.path(), {});
  ASSERT_EQ(study.size(), 1U);
  ASSERT_EQ(study[0].scene.targets.size(), 1U) << "what the camera does not see is no target";
  EXPECT_EQ(study[0].scene.targets[0].target.visible_px, 400);
  ASSERT_EQ(study[0].results.size(), 3U) << "one capture a side, three settings";
  for (const RecordedResult& result : study[0].results) {
    EXPECT_EQ(result.refused, "");
    EXPECT_TRUE(result.found.at(0));
    EXPECT_EQ(result.false_findings, 0U);
  }
  EXPECT_THAT(to_table(study), HasSubstr("1/1 100 %"));
  EXPECT_EQ(json_of(study)["inspections"][0]["targets"][0]["name"], "box");
}

TEST_F(Recorded, WhatTheTruthDoesNotNameIsFalse) {
  write_file(scene_ / "label.png", encode_png(Mask(width, height)));
  const std::vector<RecordedInspection> study = run_recorded_study(scene_, {});
  EXPECT_EQ(study.at(0).results.at(0).false_findings, 1U);
  EXPECT_TRUE(study[0].scene.targets.empty());
}

TEST_F(Recorded, APartThatIsMissingOrDoesNotFitIsNamed) {
  const auto run = [this] { static_cast<void>(run_recorded_study(folder_.path(), {})); };
  write_file(scene_ / "seen.png", encode_png(Mask(width, height - 1)));
  EXPECT_THAT(run, ThrowsMessage<Error>(HasSubstr("seen.png")));
  write_file(scene_ / "seen.png", encode_png(Mask(width, height)));
  write_file(scene_ / "final_from_initial.txt", "2 0 0 0\n0 1 0 0\n0 0 1 0\n0 0 0 1\n");
  EXPECT_THAT(run, ThrowsMessage<Error>(HasSubstr("not a rigid transform")));
  write_file(scene_ / "final_from_initial.txt", "1 0 0");
  EXPECT_THAT(run, ThrowsMessage<Error>(HasSubstr("not a rigid transform")));
  fs::remove(scene_ / "final_from_initial.txt");
  EXPECT_NO_THROW(run());
  fs::rename(scene_ / "final", scene_ / "finally");
  EXPECT_THAT(run, ThrowsMessage<Error>(HasSubstr("no capture final")));
  fs::remove(scene_ / "truth.json");
  EXPECT_THAT(run, ThrowsMessage<Error>(HasSubstr("no recorded scene")));
}

}  // namespace
}  // namespace rva
