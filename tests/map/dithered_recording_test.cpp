#include "map/dithered_recording.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "capture/capture.hpp"
#include "core/output_folder.hpp"
#include "robot/dither.hpp"
#include "sim/simulated_robot.hpp"
#include "tests/depth/stacks.hpp"
#include "tests/manual_clock.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

/// Describes its pose by the true joints of the robot.
class CarriedCamera : public Camera {
 public:
  explicit CarriedCamera(SimulatedRobot& robot) : robot_(robot) {}
  [[nodiscard]] CaptureInfo info() const override {
    const PanTilt joints = robot_.true_joints();
    CaptureInfo info = test::info_of(8, 6);
    info.pose = Pose{"here", joints.pan_deg, joints.tilt_deg, {}};
    return info;
  }
  [[nodiscard]] std::optional<CameraFrame> wait_for_frame() override {
    EXPECT_FALSE(robot_.moving());
    return CameraFrame{DepthImage(8, 6, 1000), {}, number_++, 0.0};
  }

 private:
  SimulatedRobot& robot_;
  std::uint64_t number_ = 0;
};

class DitheredRecordingTest : public testing::Test {
 protected:
  void record_at(const PanTilt& view, int captures) {
    record_dithered(camera_, robot_, clock_, {.around = view, .captures = captures, .frames = 2},
                    folder_.path(), {});
  }
  Pose pose(const char* name) {
    const auto capture = open_capture(folder_ / name);
    EXPECT_EQ(capture->depth_frames(), 2U);
    return capture->info().pose.value();
  }

  test::TemporaryFolder folder_;
  test::ManualClock time_;
  Clock clock_ = time_.clock();
  SimulatedRobot robot_{{}, clock_.now_s};
  CarriedCamera camera_{robot_};
};

TEST_F(DitheredRecordingTest, IsACaptureAtEachOffsetOfTheView) {
  record_at({0.0, -13.0}, 3);
  const std::vector<PanTilt> offsets = dither_offsets(3);
  for (const auto& [name, offset] :
       {std::pair{"dither-00", offsets[0]}, {"dither-01", offsets[1]}, {"dither-02", offsets[2]}}) {
    EXPECT_NEAR(pose(name).pan_deg.value(), offset.pan_deg, 1e-9) << name;
    EXPECT_NEAR(pose(name).tilt_deg.value(), -13.0 + offset.tilt_deg, 1e-9) << name;
  }
  EXPECT_FALSE(std::filesystem::exists(folder_ / "dither-03"));
}

TEST_F(DitheredRecordingTest, HasTheFilesOfAnOutputFolder) {
  record_at({0.0, -13.0}, most_dithers);
  EXPECT_TRUE(holds_only(folder_.path(), dithered_capture_files()));
}

}  // namespace
}  // namespace rva
