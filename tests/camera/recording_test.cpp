#include "camera/recording.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "camera/replay_camera.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/interrupt.hpp"
#include "tests/depth/stacks.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

/// Gives frames in colour, then does what a device may do.
class FailingCamera : public Camera {
 public:
  enum class Fault { unplugged, interrupted };
  FailingCamera(std::uint64_t good_frames, Fault fault) : good_frames_(good_frames), fault_(fault) {}

  [[nodiscard]] CaptureInfo info() const override {
    CaptureInfo info = test::info_of(8, 6);
    info.color = info.depth;
    return info;
  }
  [[nodiscard]] std::optional<CameraFrame> wait_for_frame() override {
    if (given_ == good_frames_ && fault_ == Fault::interrupted) throw Interrupted(2);
    if (given_ == good_frames_) throw Error("camera", "is gone", "plug it in");
    const auto shade = static_cast<std::uint8_t>(given_);
    return CameraFrame{DepthImage(8, 6, 500), ColorImage(8, 6, Rgb{shade, shade, shade}), given_++, 0.0};
  }

 private:
  std::uint64_t good_frames_;
  Fault fault_;
  std::uint64_t given_ = 0;
};

class Recording : public testing::Test {
 protected:
  Recording() {
    std::mt19937 random(7);
    frames_ = test::random_stack({8, 6, 20}, 5000, 4000, 0.2, random);
  }
  [[nodiscard]] ReplayCamera replay() const {
    return ReplayCamera(std::make_unique<test::MemoryCapture>(test::info_of(8, 6), frames_),
                        {.paced = false});
  }
  test::TemporaryFolder folder_;
  std::vector<DepthImage> frames_;
};

TEST_F(Recording, HoldsWhatTheCameraSaw) {
  ReplayCamera camera = replay();
  record(camera, frames_.size(), CaptureWriter(folder_.path(), camera.info()), {});
  const auto capture = open_capture(folder_.path());
  EXPECT_EQ(capture->info().depth, camera.info().depth);
  EXPECT_EQ(capture->color_frames(), 0U);
  ASSERT_EQ(capture->depth_frames(), frames_.size());
  for (std::size_t k = 0; k < frames_.size(); ++k) EXPECT_EQ(capture->depth(k), frames_[k]) << k;
}

TEST_F(Recording, TakesNoMoreFramesThanAsked) {
  ReplayCamera camera = replay();
  record(camera, 3, CaptureWriter(folder_.path(), camera.info()), {});
  EXPECT_EQ(open_capture(folder_.path())->depth_frames(), 3U);
  EXPECT_EQ(camera.wait_for_frame()->number, 3U);
}

TEST_F(Recording, KeepsTheColourOfEveryFrame) {
  FailingCamera camera(12, FailingCamera::Fault::unplugged);
  record(camera, 12, CaptureWriter(folder_.path(), camera.info()), {});
  const auto capture = open_capture(folder_.path());
  ASSERT_EQ(capture->color_frames(), 12U);
  for (std::size_t k = 0; k < 12; ++k) EXPECT_EQ(capture->color(k)[0].r, k);
}

TEST_F(Recording, OfAReplayGivesTheSameAgain) {
  ReplayCamera camera = replay();
  record(camera, frames_.size(), CaptureWriter(folder_.path(), camera.info()), {});
  ReplayCamera again(open_capture(folder_.path()), {.paced = false});
  for (const DepthImage& frame : frames_) EXPECT_EQ(again.wait_for_frame()->depth, frame);
  EXPECT_FALSE(again.wait_for_frame());
}

TEST_F(Recording, ReportsEveryFrame) {
  std::vector<std::size_t> reported;
  ReplayCamera camera = replay();
  record(camera, 4, CaptureWriter(folder_.path(), camera.info()),
         [&](std::string_view /*step*/, std::size_t done, std::size_t total) {
           reported.push_back(done);
           EXPECT_EQ(total, 4U);
         });
  EXPECT_EQ(reported, (std::vector<std::size_t>{1, 2, 3, 4}));
}

TEST_F(Recording, NeedsAFrame) {
  ReplayCamera camera = replay();
  const CaptureWriter writer(folder_.path(), camera.info());
  EXPECT_THROW(record(camera, 0, writer, {}), UsageError);
}

TEST_F(Recording, SaysWhenTheCameraEndsOrFails) {
  ReplayCamera camera = replay();
  const CaptureWriter writer(folder_.path(), camera.info());
  EXPECT_THROW(record(camera, frames_.size() + 1, writer, {}), Error);
  FailingCamera unplugged(5, FailingCamera::Fault::unplugged);
  EXPECT_THROW(record(unplugged, 6, writer, {}), Error);
  FailingCamera interrupted(5, FailingCamera::Fault::interrupted);
  EXPECT_THROW(record(interrupted, 6, writer, {}), Interrupted);
}

TEST_F(Recording, SaysWhenTheDiskRefuses) {
  ReplayCamera camera = replay();
  const CaptureWriter writer(folder_.path(), camera.info());
  write_file(folder_ / "depth", "in the way");
  EXPECT_THROW(record(camera, frames_.size(), writer, {}), Error);
}

TEST_F(Recording, RefusesFramesThatAreNotAsDescribed) {
  ReplayCamera camera = replay();
  const CaptureWriter writer(folder_.path(), test::info_of(6, 8));
  EXPECT_THROW(record(camera, 1, writer, {}), Error);
}

}  // namespace
}  // namespace rva
