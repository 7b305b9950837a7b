#include "camera/camera_history.hpp"

#include <gtest/gtest.h>

#include <memory>
#include <nlohmann/json.hpp>
#include <string>

#include "camera/replay_camera.hpp"
#include "capture/memory_capture.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/random.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

constexpr std::size_t frames = 8;

// A wall at one metre, with so much noise.
std::unique_ptr<Camera> camera(const std::string& serial, double noise_mm, std::uint64_t seed) {
  CaptureInfo info;
  info.depth = {32, 24, 30.0, 30.0, 15.5, 11.5, Distortion::none, {}};
  info.camera = CameraInfo{.model = "D435", .serial = serial};
  Random random(seed);
  std::vector<MemoryFrame> stack(frames);
  for (MemoryFrame& frame : stack) {
    frame.depth = DepthImage(info.depth.width, info.depth.height);
    for (std::uint16_t& value : frame.depth.pixels())
      value = static_cast<std::uint16_t>(1000.0 + noise_mm * random.normal());
  }
  return std::make_unique<ReplayCamera>(std::make_unique<MemoryCapture>(info, std::move(stack)),
                                        ReplayOptions{});
}

class CameraHistory : public testing::Test {
 protected:
  JudgedCheck check(const std::string& serial, double noise_mm, std::uint64_t seed) {
    return check_and_remember(*camera(serial, noise_mm, seed), folder_.path() / "new" / "histories", frames,
                              {}, {});
  }
  test::TemporaryFolder folder_;
};

TEST_F(CameraHistory, JudgesACameraByItsOwnEarlierChecks) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const JudgedCheck checked = check("17", 3.0, seed);
    EXPECT_FALSE(checked.judgement.known);
    EXPECT_EQ(checked.judgement.earlier, seed - 1);
  }
  EXPECT_TRUE(check("17", 3.0, 6).judgement.fit);
  const JudgedCheck noisy = check("17", 12.0, 7);
  EXPECT_TRUE(noisy.judgement.known);
  EXPECT_FALSE(noisy.judgement.fit);
  EXPECT_EQ(check("17", 3.0, 8).judgement.earlier, 6U) << "an unfit check is kept, but not judged by";
}

TEST_F(CameraHistory, BelongsToTheCamera) {
  static_cast<void>(check("17", 3.0, 1));
  EXPECT_EQ(check("18", 3.0, 2).judgement.earlier, 0U);
  EXPECT_EQ(check("17", 3.0, 3).judgement.earlier, 1U);
}

TEST_F(CameraHistory, StaysInItsFolderWhateverTheSerialNumber) {
  const JudgedCheck checked = check("../../a/b", 3.0, 1);
  EXPECT_EQ(checked.history, folder_.path() / "new" / "histories" / "------a-b.jsonl");
  EXPECT_EQ(parse_checks(read_text_file(checked.history), "history").size(), 1U);
}

TEST_F(CameraHistory, IsJsonWithLimitsOnceTheCameraIsKnown) {
  nlohmann::ordered_json json = json_of(check("17", 3.0, 1));
  EXPECT_EQ(json["known"], false);
  EXPECT_FALSE(json["quantities"][0].contains("high"));
  for (std::uint64_t seed = 2; seed <= 6; ++seed) {
    const JudgedCheck checked = check("17", 3.0, seed);
    json = json_of(checked);
    EXPECT_EQ(json["history"], checked.history.string());
  }
  EXPECT_EQ(json["format"], "rva-camera-check");
  EXPECT_EQ(json["known"], true);
  ASSERT_EQ(json["quantities"].size(), 4U);
  EXPECT_EQ(json["quantities"][0]["name"], "noise");
  EXPECT_GT(json["quantities"][0]["high"], json["quantities"][0]["value"]);
  EXPECT_FALSE(json["quantities"][0].contains("low")) << "less noise is no fault";
}

TEST_F(CameraHistory, IsUnchangedByACheckThatFails) {
  const JudgedCheck checked = check("17", 3.0, 1);
  const std::string before = read_text_file(checked.history);
  const std::unique_ptr<Camera> short_recording = camera("17", 3.0, 2);
  EXPECT_THROW(static_cast<void>(check_and_remember(*short_recording, folder_.path() / "new" / "histories",
                                                    frames + 1, {}, {})),
               Error);
  EXPECT_EQ(read_text_file(checked.history), before);
}

}  // namespace
}  // namespace rva
