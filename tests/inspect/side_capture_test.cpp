#include "inspect/side_capture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <vector>

#include "capture/capture.hpp"
#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "sim/simulated_bay.hpp"
#include "sim/simulated_robot.hpp"
#include "tests/inspect/waving_camera.hpp"
#include "tests/sim/small_scenes.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

using testing::Contains;
using testing::HasSubstr;

/// A simulated robot at the end of a cable.
class PluggedRobot : public Robot {
 public:
  [[nodiscard]] RobotLimits limits() const override { return robot_.limits(); }
  void move_to(const PanTilt& target) override { plugged().move_to(target); }
  [[nodiscard]] PanTilt joints() override { return plugged().joints(); }
  [[nodiscard]] bool moving() override { return plugged().moving(); }
  void stop() override { plugged().stop(); }

  std::atomic<bool> pulled = false;

 private:
  SimulatedRobot& plugged() {
    if (pulled) throw Error("robot", "is away", "plug it in");
    return robot_;
  }

  SimulatedRobot robot_{{.speed_deg_s = 1000.0}};
};

class Side3Views : public testing::Test {
 protected:
  Side3Views()
      : plug_(std::make_shared<test::Plug>()),
        camera_(std::make_unique<test::WavingCamera>(plug_), 1000.0),
        drive_(robot_) {}

  void take(const std::function<void(const CaptureProgress&)>& see = [](const CaptureProgress&) {}) {
    take_side({camera_, &drive_}, side_,
              {see, [this](const NoiseSoFar& noise) { noise_ = noise.median_std_mm; },
               [this](const std::string& why) { waited_.push_back(why); }});
  }
  [[nodiscard]] std::size_t captures() const {
    std::size_t count = 0;
    for (const auto& entry : std::filesystem::directory_iterator(side_.folder))
      count += entry.path().filename().string().size() == 3 ? 1U : 0U;
    return count;
  }

  test::TemporaryFolder folder_;
  std::shared_ptr<test::Plug> plug_;
  LiveCamera camera_;
  PluggedRobot robot_;
  Drive drive_;
  SideCapture side_{{{0, 0}, {5, -5}, {-5, -10}}, 1, folder_ / "initial", "base", 12};
  double noise_ = 0.0;
  std::vector<std::string> waited_;
};

TEST_F(Side3Views, AreTakenWithTheirPosesAndTheirNoiseIsReported) {
  take();
  ASSERT_EQ(captures(), 3U);
  const auto capture = open_capture(side_.folder / "001");
  EXPECT_EQ(capture->depth_frames(), 12U);
  EXPECT_NEAR(*capture->info().pose->pan_deg, 5.0, 0.4);
  EXPECT_EQ(capture->info().pose->base, "base");
  EXPECT_FALSE(capture->info().captured_at.empty());
  EXPECT_NEAR(noise_, 0.5, 0.1);
}

TEST_F(Side3Views, AreLeftAsTheyWereFound) {
  move_and_wait(robot_, {-7, 3});
  take();
  EXPECT_NEAR(robot_.joints().pan_deg, -7.0, 0.4);
  EXPECT_NEAR(robot_.joints().tilt_deg, 3.0, 0.4);
}

TEST_F(Side3Views, AreCompleteThoughTheRobotFailsOnItsWayBack) {
  take([&](const CaptureProgress& now) {
    if (now.view == 2 && now.frame == 12) robot_.pulled = true;
  });
  EXPECT_EQ(captures(), 3U);
}

TEST_F(Side3Views, ProgressCountsTheCapturesOfAView) {
  side_.captures_each = 3;
  std::vector<std::size_t> begun;
  take([&](const CaptureProgress& now) {
    EXPECT_EQ(now.view, 0U);
    EXPECT_EQ(now.views, 1U);
    EXPECT_EQ(now.captures, 3U);
    if (begun.empty() || begun.back() != now.capture) begun.push_back(now.capture);
  });
  EXPECT_THAT(begun, testing::ElementsAre(0, 1, 2));
}

TEST_F(Side3Views, AfterAnEndTheyContinueFromTheCompleteOnes) {
  EXPECT_THROW(take([](const CaptureProgress& now) {
                 if (now.view == 1 && now.frame == 6) throw Interrupted(0);
               }),
               Interrupted);
  EXPECT_EQ(captures(), 1U) << "and nothing half written";
  std::vector<std::size_t> taken;
  take([&](const CaptureProgress& now) { taken.push_back(now.view); });
  EXPECT_EQ(captures(), 3U);
  EXPECT_THAT(taken, testing::Not(Contains(0U))) << "the first was there";
}

TEST_F(Side3Views, ACameraThatIsUnpluggedIsWaitedForAndTheViewTakenAnew) {
  bool pulled = false;
  take([&](const CaptureProgress& now) {
    if (now.view == 1 && now.frame == 6 && !pulled) pulled = plug_->pulled = true;
    if (!waited_.empty()) plug_->pulled = false;
  });
  EXPECT_EQ(captures(), 3U);
  EXPECT_EQ(open_capture(side_.folder / "001")->depth_frames(), 12U);
  ASSERT_FALSE(waited_.empty());
  EXPECT_THAT(waited_.front(), HasSubstr("unplugged"));
  EXPECT_EQ(waited_.back(), "") << "and its return is reported";
}

TEST_F(Side3Views, OfAFrozenCameraAreRefusedAndNotRecorded) {
  const auto freeze = [&](const CaptureProgress& now) {
    if (now.view == 1 && now.frame == 0) plug_->frozen = true;
  };
  EXPECT_THAT([&] { take(freeze); }, testing::ThrowsMessage<Error>(HasSubstr("the camera was frozen")));
  EXPECT_EQ(captures(), 1U) << "the one of before, and nothing half written";
  EXPECT_TRUE(waited_.empty()) << "no device is away";
  plug_->frozen = false;
  take();
  EXPECT_EQ(captures(), 3U);
}

// At every tick of the way from the first view on: what is known of the robot may be of before.
TEST_F(Side3Views, ARobotThatIsUnpluggedIsWaitedFor) {
  for (int at = 0; at < 4; ++at) {
    side_.folder = folder_ / std::to_string(at);
    waited_.clear();
    int ticks = 0;
    take([&](const CaptureProgress& now) {
      if (now.view == 1 && ticks++ == at) robot_.pulled = true;
      if (!waited_.empty()) robot_.pulled = false;
    });
    EXPECT_EQ(captures(), 3U);
    ASSERT_FALSE(waited_.empty()) << at;
    EXPECT_THAT(waited_.front(), HasSubstr("is away"));
  }
}

TEST_F(Side3Views, AStopIsNoDeviceThatIsAway) {
  robot_.move_to({-60, -60});
  EXPECT_THROW(take([&](const CaptureProgress& now) {
                 if (now.frame == 0) robot_.stop();
               }),
               Error);
  EXPECT_TRUE(waited_.empty());
}

TEST_F(Side3Views, BeyondTheLimitsNothingMoves) {
  side_.waypoints.push_back({0, 60});
  EXPECT_THROW(take(), UsageError);
  EXPECT_EQ(robot_.joints(), PanTilt{});
}

class UnderALamp : public testing::Test {
 protected:
  static Scene wall() {
    Scene scene = test::room_with_wall(0.6);
    scene.stand.base = "base";
    return scene;
  }
  void take(const InspectionRig& rig, bool lamp) {
    side_.lamp = lamp;
    take_side(rig, side_,
              {[](const CaptureProgress&) {}, [](const NoiseSoFar&) {}, [](const std::string&) {}});
  }
  [[nodiscard]] bool has_lamp_images(const char* view) const {
    const auto capture = open_capture(side_.folder / view);
    return capture->has_infrared(Imager::left, Light::lamp) &&
           capture->has_infrared(Imager::right, Light::lamp);
  }

  test::TemporaryFolder folder_;
  PluggedRobot robot_;
  LiveCamera camera_{std::make_unique<SimulatedBay>(wall(), wall(), 1, [this] { return robot_.joints(); }),
                     1000.0};
  SideCapture side_{{{0, 0}}, 1, folder_ / "initial", "base", 2};
};

TEST_F(UnderALamp, EachCaptureHasItsImagesWithARobotAndWithout) {
  take({camera_}, true);
  EXPECT_TRUE(has_lamp_images("000"));
  EXPECT_EQ(open_capture(side_.folder / "000")->depth_frames(), 2U) << "none of them under the lamp";
  side_.folder = folder_ / "with a robot";
  side_.waypoints = {{0, 0}, {1, 0}};
  Drive drive(robot_);
  take({camera_, &drive}, true);
  EXPECT_TRUE(has_lamp_images("000"));
  EXPECT_TRUE(has_lamp_images("001"));
}

TEST_F(UnderALamp, CapturesWithAndWithoutAreNotMixed) {
  Drive drive(robot_);
  take({camera_, &drive}, false);
  EXPECT_FALSE(has_lamp_images("000"));
  side_.waypoints = {{0, 0}, {1, 0}};
  EXPECT_THAT(
      [&] {
        take({camera_, &drive}, true);
      },
      testing::ThrowsMessage<Error>(HasSubstr("has no images under the lamp")));
}

TEST(StandingCamera, ThatIsFrozenIsRefusedAndNothingIsRecorded) {
  const test::TemporaryFolder folder;
  const auto plug = std::make_shared<test::Plug>();
  plug->frozen = true;
  LiveCamera camera(std::make_unique<test::WavingCamera>(plug), 1000.0);
  const SideCapture side{{{0, 0}}, 1, folder / "initial", "base", 8};
  const CaptureEvents events{[](const CaptureProgress&) {}, [](const NoiseSoFar&) {},
                             [](const std::string&) {}};
  EXPECT_THAT([&] { take_side({camera}, side, events); },
              testing::ThrowsMessage<Error>(HasSubstr("restart the camera")));
  EXPECT_FALSE(std::filesystem::exists(side.folder / "000"));
}

TEST(StandingCamera, TakesNoEarlierCaptureForItsView) {
  const test::TemporaryFolder folder;
  const auto plug = std::make_shared<test::Plug>();
  LiveCamera camera(std::make_unique<test::WavingCamera>(plug), 1000.0);
  const SideCapture side{{{0, 0}}, 1, folder / "initial", "base", 8};
  std::size_t frames = 0;
  const CaptureEvents events{[&](const CaptureProgress&) { ++frames; }, [](const NoiseSoFar&) {},
                             [](const std::string&) {}};
  const std::string taken_at = take_side({camera}, side, events);
  EXPECT_EQ(open_capture(side.folder / "000")->depth_frames(), 8U);
  EXPECT_EQ(open_capture(side.folder / "000")->info().captured_at, taken_at);
  EXPECT_GE(frames, 8U);
  EXPECT_THROW(take_side({camera}, side, events), Error) << "a round has a folder of its own";
}

}  // namespace
}  // namespace rva
