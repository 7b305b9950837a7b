#include "map/view_capture.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>

#include "capture/capture.hpp"
#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "sim/simulated_robot.hpp"
#include "tests/depth/stacks.hpp"
#include "tests/manual_clock.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;

/// Every frame contains the pan at which it was taken; fails, or is interrupted, on request.
class PanCamera : public Camera {
 public:
  explicit PanCamera(Robot& robot) : robot_(robot) {}
  [[nodiscard]] CaptureInfo info() const override { return test::info_of(8, 6); }
  [[nodiscard]] std::optional<CameraFrame> wait_for_frame() override {
    if (frames_left == 0) throw Error("camera", "is gone", "plug it in");
    --frames_left;
    const PanTilt joints = robot_.joints();
    EXPECT_FALSE(robot_.moving());
    return CameraFrame{
        DepthImage(8, 6, static_cast<std::uint16_t>(1000.0 + joints.pan_deg)), {}, number_++, 0.0};
  }
  int frames_left = 1000000;

 private:
  Robot& robot_;
  std::uint64_t number_ = 0;
};

class ViewCapture : public testing::Test {
 protected:
  void take(const std::vector<PanTilt>& waypoints) {
    take_views({camera_, robot_, clock_, chain_, base_}, waypoints, folder_.path(),
               {.frames = 3, .settling = 1}, {});
  }
  std::unique_ptr<Capture> view(const char* name) { return open_capture(folder_ / name); }

  test::TemporaryFolder folder_;
  test::ManualClock time_;
  Clock clock_ = time_.clock();
  SimulatedRobot robot_{{}, clock_.now_s};
  PanCamera camera_{robot_};
  PanTiltChain chain_;
  std::string base_ = "here";
  std::vector<PanTilt> waypoints_{{-40, -30}, {0, -30}, {40, -10}};
};

TEST_F(ViewCapture, TakesOneAtEachWaypoint) {
  take(waypoints_);
  for (const auto& [name, pan_deg] : {std::pair{"000", -40.0}, {"001", 0.0}, {"002", 40.0}}) {
    const auto capture = view(name);
    EXPECT_EQ(capture->depth_frames(), 3U);
    const Pose pose = capture->info().pose.value();
    EXPECT_EQ(pose.base, "here");
    EXPECT_NEAR(pose.pan_deg.value(), pan_deg, 0.5 * servo_step_deg);
    EXPECT_TRUE(pose.world_from_camera->isApprox(
        foot_from_camera(chain_, {pose.pan_deg.value(), pose.tilt_deg.value()}), 1e-9));
    EXPECT_NEAR(capture->depth(2)[0], 1000.0 + pan_deg, 1.0);
  }
}

TEST_F(ViewCapture, ArrivesFromBelowSoThatPlayIsOnOneSide) {
  std::vector<PanTilt> back{{40, -10}, {-40, -30}};
  take(back);
  EXPECT_NEAR(robot_.true_joints().pan_deg, robot_.joints().pan_deg, 1e-9);
  EXPECT_NEAR(robot_.true_joints().tilt_deg, robot_.joints().tilt_deg, 1e-9);
}

TEST_F(ViewCapture, ChecksAllWaypointsBeforeAnythingMoves) {
  waypoints_.push_back({0, 40});
  EXPECT_THAT([&] { take(waypoints_); }, ThrowsMessage<UsageError>(HasSubstr("waypoint 4")));
  EXPECT_FALSE(robot_.moving());
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
}

TEST_F(ViewCapture, GoesOnWhereItFailed) {
  camera_.frames_left = 4 + 2;  // the second view breaks off
  EXPECT_THAT([&] { take(waypoints_); }, ThrowsMessage<Error>(HasSubstr("is gone")));
  EXPECT_TRUE(std::filesystem::exists(folder_ / "000"));
  EXPECT_FALSE(std::filesystem::exists(folder_ / "001"));
  const auto before = std::filesystem::last_write_time(folder_ / "000" / "capture.json");
  camera_.frames_left = 2 * 4;  // enough for what is missing
  take(waypoints_);
  EXPECT_EQ(view("002")->depth_frames(), 3U);
  EXPECT_EQ(std::filesystem::last_write_time(folder_ / "000" / "capture.json"), before);
  camera_.frames_left = 0;
  take(waypoints_);  // nothing is left to be done
}

TEST_F(ViewCapture, DoesNotMixTwoMaps) {
  take(waypoints_);
  EXPECT_THAT(
      [&] {
        take({{-40, -30}, {9, -30}, {40, -10}});
      },
      ThrowsMessage<Error>(HasSubstr("was not taken at pan 9.00")));
  base_ = "elsewhere";
  EXPECT_THAT([&] { take(waypoints_); }, ThrowsMessage<Error>(HasSubstr("another base")));
}

}  // namespace
}  // namespace rva
