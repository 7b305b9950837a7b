#include "camera/recording.hpp"

#include <gtest/gtest.h>

#include <utility>
#include <vector>

#include "camera/replay_camera.hpp"
#include "capture/folder/capture_writer.hpp"
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
    CameraFrame frame{DepthImage(8, 6, 500), ColorImage(8, 6, Rgb{shade, shade, shade}), given_++, 0.0};
    const int level = light_ == Light::lamp ? 100 : shade;
    frame.infrared.emplace(Imager::left, fine_gray(GrayImage(8, 6, static_cast<std::uint8_t>(level))));
    frame.infrared.emplace(Imager::right, fine_gray(GrayImage(8, 6, static_cast<std::uint8_t>(2 * level))));
    frame.metadata.exposure_us = 5000.0;
    return frame;
  }
  [[nodiscard]] bool has_lamp() const override { return true; }
  void set_light(Light light) override { light_ = light; }
  [[nodiscard]] Light light() const { return light_; }

 private:
  std::uint64_t good_frames_;
  Fault fault_;
  std::uint64_t given_ = 0;
  Light light_ = Light::projector;
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

TEST_F(Recording, ContainsWhatTheCameraSaw) {
  ReplayCamera camera = replay();
  CaptureWriter writer(folder_.path(), camera.info());
  record(camera, frames_.size(), writer, {});
  const auto capture = open_capture(folder_.path());
  EXPECT_EQ(capture->info().depth, camera.info().depth);
  EXPECT_EQ(capture->color_frames(), 0U);
  ASSERT_EQ(capture->depth_frames(), frames_.size());
  for (std::size_t k = 0; k < frames_.size(); ++k) EXPECT_EQ(capture->depth(k), frames_[k]) << k;
}

TEST_F(Recording, TakesNoMoreFramesThanAsked) {
  ReplayCamera camera = replay();
  CaptureWriter writer(folder_.path(), camera.info());
  record(camera, 3, writer, {});
  EXPECT_EQ(open_capture(folder_.path())->depth_frames(), 3U);
  EXPECT_EQ(camera.wait_for_frame()->number, 3U);
}

TEST_F(Recording, KeepsTheColourOfEveryFrame) {
  FailingCamera camera(12, FailingCamera::Fault::unplugged);
  CaptureWriter writer(folder_.path(), camera.info());
  record(camera, 12, writer, {});
  const auto capture = open_capture(folder_.path());
  ASSERT_EQ(capture->color_frames(), 12U);
  for (std::size_t k = 0; k < 12; ++k) EXPECT_EQ(capture->color(k)[0].r, k);
}

TEST_F(Recording, KeepsTheMeanOfWhatBothInfraredImagersSaw) {
  FailingCamera camera(4, FailingCamera::Fault::unplugged);
  CaptureWriter writer(folder_.path(), camera.info());
  record(camera, 4, writer, {});
  const auto capture = open_capture(folder_.path());
  EXPECT_FLOAT_EQ((*capture->infrared_mean(Imager::left, Light::projector))[0], 1.5F);
  EXPECT_FLOAT_EQ((*capture->infrared_mean(Imager::right, Light::projector))[0], 3.0F);
  EXPECT_EQ(capture->info().infrared, (InfraredBurst{256.0, 4, 5000.0}));
  EXPECT_FALSE(capture->has_infrared(Imager::left, Light::lamp));
}

TEST_F(Recording, KeepsTheMeanUntilTheCameraFails) {
  FailingCamera camera(3, FailingCamera::Fault::unplugged);
  CaptureWriter writer(folder_.path(), camera.info());
  EXPECT_THROW(record(camera, 4, writer, {}), Error);
  EXPECT_FLOAT_EQ((*open_capture(folder_.path())->infrared_mean(Imager::left, Light::projector))[0], 1.0F);
}

TEST_F(Recording, TakesABurstUnderTheLampAndTurnsTheProjectorOnAgain) {
  FailingCamera camera(5, FailingCamera::Fault::unplugged);
  CaptureWriter writer(folder_.path(), camera.info());
  record(camera, 2, writer, {});
  record_lamp(camera, 3, writer, {});
  EXPECT_EQ(camera.light(), Light::projector);
  EXPECT_THROW(record_lamp(camera, 1, writer, {}), Error);
  EXPECT_EQ(camera.light(), Light::projector) << "and where the camera fails";
  EXPECT_THROW(record_lamp(camera, 0, writer, {}), UsageError);
  const auto capture = open_capture(folder_.path());
  EXPECT_FLOAT_EQ((*capture->infrared_mean(Imager::left, Light::lamp))[0], 100.0F);
  EXPECT_EQ(capture->info().lamp, (InfraredBurst{256.0, 3, 5000.0}));
  EXPECT_FLOAT_EQ((*capture->infrared_mean(Imager::left, Light::projector))[0], 0.5F);
}

TEST_F(Recording, OfAReplayHasTheSameInfraredImages) {
  FailingCamera camera(5, FailingCamera::Fault::unplugged);
  CaptureWriter writer(folder_.path(), camera.info());
  record(camera, 3, writer, {});
  record_lamp(camera, 2, writer, {});
  ReplayCamera replayed(open_capture(folder_.path()), {.paced = false});
  ASSERT_TRUE(replayed.has_lamp());
  const test::TemporaryFolder copy;
  CaptureWriter again(copy.path(), replayed.info());
  record(replayed, 3, again, {});
  record_lamp(replayed, 2, again, {});
  const auto first = open_capture(folder_.path());
  const auto second = open_capture(copy.path());
  for (const Imager imager : both_imagers) {
    for (const Light light : {Light::projector, Light::lamp})
      EXPECT_EQ(second->infrared_mean(imager, light), first->infrared_mean(imager, light));
  }
}

TEST_F(Recording, UnderALampNeedsInfraredImages) {
  ReplayCamera camera = replay();
  EXPECT_FALSE(camera.has_lamp());
}

TEST_F(Recording, OfAReplayGivesTheSameAgain) {
  ReplayCamera camera = replay();
  CaptureWriter writer(folder_.path(), camera.info());
  record(camera, frames_.size(), writer, {});
  ReplayCamera again(open_capture(folder_.path()), {.paced = false});
  for (const DepthImage& frame : frames_) EXPECT_EQ(again.wait_for_frame()->depth, frame);
  EXPECT_FALSE(again.wait_for_frame());
}

TEST_F(Recording, ReportsEveryFrame) {
  std::vector<std::size_t> reported;
  ReplayCamera camera = replay();
  CaptureWriter writer(folder_.path(), camera.info());
  record(camera, 4, writer, [&](std::string_view /*step*/, std::size_t done, std::size_t total) {
    reported.push_back(done);
    EXPECT_EQ(total, 4U);
  });
  EXPECT_EQ(reported, (std::vector<std::size_t>{1, 2, 3, 4}));
}

TEST_F(Recording, NeedsAFrame) {
  ReplayCamera camera = replay();
  CaptureWriter writer(folder_.path(), camera.info());
  EXPECT_THROW(record(camera, 0, writer, {}), UsageError);
}

TEST_F(Recording, SaysWhenTheCameraEndsOrFails) {
  ReplayCamera camera = replay();
  CaptureWriter writer(folder_.path(), camera.info());
  EXPECT_THROW(record(camera, frames_.size() + 1, writer, {}), Error);
  FailingCamera unplugged(5, FailingCamera::Fault::unplugged);
  EXPECT_THROW(record(unplugged, 6, writer, {}), Error);
  FailingCamera interrupted(5, FailingCamera::Fault::interrupted);
  EXPECT_THROW(record(interrupted, 6, writer, {}), Interrupted);
}

TEST_F(Recording, SaysWhenTheDiskRefuses) {
  ReplayCamera camera = replay();
  CaptureWriter writer(folder_.path(), camera.info());
  write_file(folder_ / "depth", "in the way");
  EXPECT_THROW(record(camera, frames_.size(), writer, {}), Error);
}

TEST_F(Recording, RefusesFramesThatAreNotAsDescribed) {
  ReplayCamera camera = replay();
  CaptureWriter writer(folder_.path(), test::info_of(6, 8));
  EXPECT_THROW(record(camera, 1, writer, {}), Error);
}

}  // namespace
}  // namespace rva
