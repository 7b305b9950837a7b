#include "camera/capture_recording.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>

#include "capture/folder/capture_writer.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "tests/depth/stacks.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::ThrowsMessage;

/// A device that fails, or is interrupted, after a number of frames.
class FailingDevice : public Camera {
 public:
  enum class Fault { unplugged, interrupted };
  explicit FailingDevice(std::uint64_t good_frames, Fault fault = Fault::unplugged)
      : good_frames_(good_frames), fault_(fault) {}

  [[nodiscard]] CaptureInfo info() const override { return test::info_of(8, 6); }
  [[nodiscard]] std::optional<CameraFrame> wait_for_frame() override {
    if (given_ == good_frames_ && fault_ == Fault::interrupted) throw Interrupted(2);
    if (given_ == good_frames_) throw Error("camera", "is gone", "plug it in");
    CameraFrame frame{DepthImage(8, 6, static_cast<std::uint16_t>(500 + given_)), std::nullopt, given_, 0.0};
    ++given_;
    frame.infrared.emplace(Imager::left, fine_gray(GrayImage(8, 6, 10)));
    return frame;
  }
  [[nodiscard]] bool has_lamp() const override { return true; }
  void set_light(Light /*light*/) override {}

 private:
  std::uint64_t good_frames_;
  Fault fault_;
  std::uint64_t given_ = 0;
};

constexpr CaptureRecording six_and_lamp{.frames = 6, .lamp = true, .keep = true};

/// Records into a folder or into an MCAP file, and finds what was kept.
class CaptureRecordingTest : public testing::TestWithParam<std::string> {
 protected:
  Recorded record_from(Camera& camera, const CaptureRecording& recording) {
    if (target_.extension() == ".mcap") return record_capture(camera, recording, target_, {});
    OutputFolder out(target_, capture_files(), Existing::refuse, Remains::keep);
    return record_capture(camera, recording, out, {});
  }

  /// The only entry of the test's folder; empty where there is none.
  [[nodiscard]] fs::path kept() const {
    fs::path only;
    for (const fs::directory_entry& entry : fs::directory_iterator(folder_.path())) {
      EXPECT_TRUE(only.empty()) << "besides " << entry.path();
      only = entry.path();
    }
    return only;
  }

  void expect_kept(std::size_t frames) const {
    ASSERT_FALSE(kept().empty());
    const auto capture = open_capture(kept());
    ASSERT_EQ(capture->depth_frames(), frames);
    for (std::size_t k = 0; k < frames; ++k) EXPECT_EQ(capture->depth(k)[0], 500 + k);
  }

  void expect_kept_after_failure(Camera& camera, std::size_t frames) {
    try {
      record_from(camera, six_and_lamp);
      FAIL() << "the camera is gone";
    } catch (const Error& error) {
      EXPECT_THAT(error.problem(), HasSubstr("is gone"));
      EXPECT_THAT(error.problem(), HasSubstr(std::to_string(frames) + " frame(s)"));
      EXPECT_THAT(error.problem(), HasSubstr(kept().string()));
    }
    expect_kept(frames);
  }

  test::TemporaryFolder folder_;
  fs::path target_ = folder_ / GetParam();
};

TEST_P(CaptureRecordingTest, IsCompleteUnderTheNameOfItsTarget) {
  FailingDevice camera(12);
  EXPECT_EQ(record_from(camera, six_and_lamp).frames, 6U);
  EXPECT_EQ(kept(), target_);
  expect_kept(6);
  EXPECT_TRUE(open_capture(target_)->has_infrared(Imager::left, Light::lamp));
}

TEST_P(CaptureRecordingTest, KeepsTheFramesBeforeAFailure) {
  FailingDevice camera(4);
  expect_kept_after_failure(camera, 4);
}

TEST_P(CaptureRecordingTest, KeepsTheFramesBeforeAFailureUnderTheLamp) {
  FailingDevice camera(8);
  expect_kept_after_failure(camera, 6);
}

TEST_P(CaptureRecordingTest, KeepsTheFramesBeforeAnInterruption) {
  for (const std::uint64_t good_frames : {4U, 8U}) {
    FailingDevice camera(good_frames, FailingDevice::Fault::interrupted);
    const std::size_t frames = std::min<std::size_t>(good_frames, 6);
    try {
      record_from(camera, six_and_lamp);
      FAIL() << "it was interrupted";
    } catch (const RecordingInterrupted& interrupted) {
      EXPECT_EQ(interrupted.signal(), 2);
      EXPECT_EQ(interrupted.frames(), frames);
      EXPECT_EQ(interrupted.kept(), kept());
    }
    expect_kept(frames);
    fs::remove_all(kept());
  }
}

TEST_P(CaptureRecordingTest, LeavesNothingWithoutAFrame) {
  FailingDevice camera(0);
  EXPECT_THAT([&] { record_from(camera, six_and_lamp); },
              ThrowsMessage<Error>(testing::Not(HasSubstr("kept"))));
  EXPECT_EQ(kept(), fs::path());
}

TEST_P(CaptureRecordingTest, LeavesNothingOfARepeatableCamera) {
  for (const std::uint64_t good_frames : {4U, 8U}) {
    FailingDevice camera(good_frames);
    EXPECT_THAT([&] { record_from(camera, {.frames = 6, .lamp = true}); },
                ThrowsMessage<Error>(testing::Not(HasSubstr("kept"))));
    EXPECT_EQ(kept(), fs::path());
  }
}

INSTANTIATE_TEST_SUITE_P(Formats, CaptureRecordingTest, testing::Values("capture", "capture.mcap"),
                         [](const auto& format) { return format.index == 0 ? "Folder" : "Mcap"; });

TEST(CaptureRecording, IsKeptWhereItsTargetWasTakenMeanwhile) {
  const test::TemporaryFolder folder;
  FailingDevice camera(6);
  OutputFolder out(folder / "capture", capture_files(), Existing::refuse, Remains::keep);
  fs::create_directory(folder / "capture");
  write_file(folder / "capture" / "notes.txt", "of another program");
  EXPECT_THAT([&] { record_capture(camera, {.frames = 6, .keep = true}, out, {}); },
              ThrowsMessage<Error>(HasSubstr("6 frame(s) until then are kept in")));
  EXPECT_EQ(open_capture(out.path(""))->depth_frames(), 6U);
}

}  // namespace
}  // namespace rva
