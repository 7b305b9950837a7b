#include "map/bay_map.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "sim/simulated_robot.hpp"
#include "tests/depth/stacks.hpp"
#include "tests/manual_clock.hpp"
#include "tests/temporary_folder.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

using testing::HasSubstr;
using testing::ThrowsMessage;
using Start = ViewFolder::Start;

/// Faces a wall one metre ahead in every direction.
class WallCamera : public Camera {
 public:
  [[nodiscard]] CaptureInfo info() const override { return test::info_of(64, 48); }
  [[nodiscard]] std::optional<CameraFrame> wait_for_frame() override {
    if (frames_left == 0) throw Error("camera", "is gone", "plug it in");
    --frames_left;
    return CameraFrame{DepthImage(64, 48, 1000), {}, number_++, 0.0};
  }
  int frames_left = 1000000;

 private:
  std::uint64_t number_ = 0;
};

class BayMapTest : public testing::Test {
 protected:
  BayMapTest() {
    options_.capture = {.frames = 3, .settling = 1};
    options_.refine = false;
  }
  BayMap make(Start start = Start::anew) {
    return map_bay({camera_, robot_, clock_, chain_, base_}, waypoints_, files_, start, options_, {});
  }

  test::TemporaryFolder folder_;
  test::ManualClock time_;
  Clock clock_ = time_.clock();
  SimulatedRobot robot_{{}, clock_.now_s};
  WallCamera camera_;
  PanTiltChain chain_;
  std::string base_ = "here";
  std::vector<PanTilt> waypoints_{{-40, -30}, {40, -10}};
  MapFiles files_ = map_files(folder_ / "map.ply");
  BayMapOptions options_;
};

TEST_F(BayMapTest, HasAViewOfEachWaypointAtThePoseOfTheJoints) {
  const BayMap map = make();
  EXPECT_EQ(map.poses.base, "here");
  EXPECT_FALSE(map.poses.refined);
  EXPECT_GT(map.points, 0U);
  ASSERT_EQ(map.views.size(), 2U);
  ASSERT_EQ(map.poses.poses.size(), 2U);
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_NEAR(map.views[i].joints.pan_deg, waypoints_[i].pan_deg, 0.33) << "within a servo step";
    EXPECT_NEAR(map.views[i].joints.tilt_deg, waypoints_[i].tilt_deg, 0.33);
    EXPECT_TRUE(
        map.poses.poses[i].foot_from_camera.isApprox(foot_from_camera(chain_, map.views[i].joints), 1e-12));
  }
  EXPECT_EQ(map.views[1].name, "map.views/001");
  for (const char* const name : {"map.ply", "map.pcd", "map.json", "map.views/000", "map.views/001"})
    EXPECT_TRUE(fs::exists(folder_ / name)) << name;
}

TEST_F(BayMapTest, BeginsAnewOnlyWhereThereAreNoViews) {
  make();
  EXPECT_THAT([&] { make(); }, ThrowsMessage<Error>(HasSubstr("map.views")));
  EXPECT_EQ(make(Start::replace).views.size(), 2U);
  EXPECT_FALSE(fs::exists(folder_ / "map.views.next"));
}

TEST_F(BayMapTest, GoesOnAfterAFailure) {
  constexpr int of_a_view = 4;  // those recorded and those dropped while the robot came to rest
  camera_.frames_left = of_a_view + 2;
  EXPECT_THAT([&] { make(); }, ThrowsMessage<Error>(HasSubstr("is gone")));
  EXPECT_TRUE(fs::exists(folder_ / "map.views" / "000"));
  EXPECT_FALSE(fs::exists(folder_ / "map.ply"));
  camera_.frames_left = of_a_view;
  EXPECT_EQ(make(Start::resume).views.size(), 2U);
}

TEST_F(BayMapTest, NamesAViewThatCannotBeRead) {
  make();
  fs::remove_all(folder_ / "map.views" / "001" / "depth");
  fs::create_directory(folder_ / "map.views" / "001" / "depth");
  EXPECT_THAT([&] { make(Start::resume); }, ThrowsMessage<Error>(HasSubstr("map.views/001")));
}

TEST_F(BayMapTest, IsNotWrittenWithoutAPoint) {
  options_.cloud.near_m = 1.5;
  EXPECT_THROW(make(), EmptyMapError);
  EXPECT_FALSE(fs::exists(folder_ / "map.ply"));
  EXPECT_TRUE(fs::exists(folder_ / "map.views" / "001")) << "another range of distances needs no new views";
  options_.cloud.near_m = 0.5;
  EXPECT_GT(make(Start::resume).points, 0U);
}

TEST_F(BayMapTest, IsRefusedBeforeAnythingMoves) {
  const auto expect_refused = [&] {
    EXPECT_THROW(make(), UsageError);
    EXPECT_FALSE(robot_.moving());
    EXPECT_TRUE(fs::is_empty(folder_.path()));
  };
  waypoints_.push_back({0, 40});
  expect_refused();
  waypoints_.pop_back();
  options_.cloud.near_m = options_.cloud.far_m;
  expect_refused();
  options_.cloud.near_m = 0.1;
  options_.refinement.servo_error_deg = -1.0;
  expect_refused();
}

}  // namespace
}  // namespace rva
