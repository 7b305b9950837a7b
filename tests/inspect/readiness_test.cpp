#include "inspect/readiness.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "core/date_time.hpp"
#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/random.hpp"
#include "geometry/stereo_scale.hpp"
#include "tests/eventually.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

using testing::AllOf;
using testing::ElementsAre;
using testing::HasSubstr;

constexpr int width = 160;
constexpr int height = 120;
constexpr StereoScale stereo{.focal_baseline_m_px = 212.0 * 0.05, .unit_m = 0.0001};

/// Disparity of a pixel in a frame; 0 for no measurement.
using Surface = std::function<double(int u, int v, std::uint64_t frame)>;

/// A camera of which every frame is known.
class KnownCamera : public Camera {
 public:
  explicit KnownCamera(Surface surface, bool frozen = false)
      : surface_(std::move(surface)), frozen_(frozen) {}
  [[nodiscard]] CaptureInfo info() const override {
    CaptureInfo info;
    info.format = "rva-capture";
    info.depth = {width, height, 212.0, 212.0, 79.5, 59.5};
    info.depth_unit_m = stereo.unit_m;
    info.camera = CameraInfo{"D435 of this test", "1", 0.05};
    return info;
  }
  [[nodiscard]] std::optional<CameraFrame> wait_for_frame() override {
    DepthImage depth(width, height);
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        const double disparity_px = surface_(u, v, number_);
        if (disparity_px > 0.0)
          depth(u, v) = static_cast<std::uint16_t>(std::lround(stereo.depth_m(disparity_px) / stereo.unit_m));
      }
    }
    // The least noise: without any, the camera would be frozen.
    if (!frozen_ && depth(0, 0) != no_depth) depth(0, 0) += number_ % 2;
    return CameraFrame{std::move(depth), std::nullopt, number_++, 0.0};
  }

 private:
  Surface surface_;
  bool frozen_;
  std::uint64_t number_ = 0;
};

constexpr double wall_px = 13.0;
double wall(int /*u*/, int /*v*/, std::uint64_t /*frame*/) { return wall_px; }

/// A wall that moves by a constant disparity from frame to frame.
Surface drifting(double px_per_frame) {
  return [=](int, int, std::uint64_t frame) { return wall_px + px_per_frame * static_cast<double>(frame); };
}

std::vector<std::string> codes_of(const Readiness& readiness) {
  std::vector<std::string> codes;
  for (const ReadinessItem& item : readiness.items) codes.push_back(item.code);
  return codes;
}

class ReadinessTest : public testing::Test {
 protected:
  Readiness check(const Surface& surface, double most_hz = 500.0) {
    LiveCamera camera(std::make_unique<KnownCamera>(surface), most_hz);
    return check_readiness(camera, drive_, folder_.path(), options_, progress_);
  }
  /// The item that is not ready; all others must be.
  ReadinessItem only_problem(const Readiness& readiness) const {
    ReadinessItem problem;
    for (const ReadinessItem& item : readiness.items) {
      if (item.ready) continue;
      EXPECT_EQ(problem.name, "") << item.name << ": " << item.says;
      problem = item;
    }
    EXPECT_EQ(readiness.ready(), problem.name.empty());
    return problem;
  }

  test::TemporaryFolder folder_;
  const Drive* drive_ = nullptr;
  ReadinessOptions options_{.frames = 8, .least_rate_hz = 0.0, .least_free_gb = 0.0};
  Progress progress_;
};

TEST_F(ReadinessTest, OfEverythingThatIsInOrderIsReady) {
  const std::string before = iso_8601_now();
  const Readiness readiness = check(wall);
  EXPECT_TRUE(readiness.ready());
  std::string names;
  for (const ReadinessItem& item : readiness.items) names += item.name + " ";
  EXPECT_EQ(names, "Camera Depth Warm-up Robot Disk ");
  EXPECT_THAT(codes_of(readiness),
              ElementsAre("camera-ready", "depth-ready", "camera-stable", "robot-none", "disk-ready"));
  EXPECT_EQ(readiness.items.at(0).values.at("width_px"), 160.0);
  EXPECT_EQ(readiness.items.at(1).values.at("measured"), 1.0);
  EXPECT_THAT(readiness.items.at(0).says, HasSubstr("D435 of this test, 160 x 120 pixels"));
  EXPECT_EQ(readiness.items.at(1).says, "100 % of the view is measured.");
  EXPECT_THAT(readiness.items.at(2).says, HasSubstr("stable: depth at one metre moved by 0.00 mm"));
  EXPECT_THAT(readiness.items.at(3).says, HasSubstr("No robot"));
  EXPECT_THAT(readiness.items.at(4).says, HasSubstr("GB free."));
  EXPECT_GE(readiness.checked_at, before);
  EXPECT_LE(readiness.checked_at, iso_8601_now());
}

TEST_F(ReadinessTest, ReportsEachFrame) {
  std::vector<std::size_t> done;
  progress_ = [&](std::string_view, std::size_t frame, std::size_t total) {
    EXPECT_EQ(total, 8U);
    done.push_back(frame);
  };
  static_cast<void>(check(wall));
  EXPECT_EQ(done, (std::vector<std::size_t>{1, 2, 3, 4, 5, 6, 7, 8}));
}

TEST_F(ReadinessTest, OfASlowCameraIsNot) {
  options_.least_rate_hz = 200.0;
  const ReadinessItem problem = only_problem(check(wall, 100.0));
  EXPECT_EQ(problem.name, "Camera");
  EXPECT_THAT(problem.says, HasSubstr("frames per second: too few. Use a USB 3 port"));
  EXPECT_EQ(problem.code, "camera-slow");
}

TEST_F(ReadinessTest, OfACameraThatIsFrozenIsNot) {
  LiveCamera camera(std::make_unique<KnownCamera>(wall, true), 500.0);
  const ReadinessItem problem = only_problem(check_readiness(camera, drive_, folder_.path(), options_, {}));
  EXPECT_EQ(problem.name, "Camera");
  EXPECT_THAT(problem.says,
              AllOf(HasSubstr("It is frozen: 7 of 8 depth images are the same as the one before"),
                    HasSubstr("connect it again")));
  EXPECT_EQ(problem.code, "camera-frozen");
  EXPECT_EQ(problem.values, (std::map<std::string, double>{{"repeated_frames", 7}, {"frames", 8}}));
}

TEST_F(ReadinessTest, OfACameraThatGivesMostImagesTwiceIsNot) {
  const auto given = [](std::uint64_t times) -> Surface {
    return [=](int, int, std::uint64_t frame) { return frame / times % 2 == 0 ? wall_px : wall_px + 0.02; };
  };
  const auto check_frozen = [&](std::uint64_t times) {
    LiveCamera camera(std::make_unique<KnownCamera>(given(times), true), 500.0);
    return check_readiness(camera, drive_, folder_.path(),
                           {.frames = 40, .least_rate_hz = 0.0, .most_drift_px = 1.0, .least_free_gb = 0.0},
                           {});
  };
  EXPECT_TRUE(check_frozen(1).ready());
  EXPECT_EQ(only_problem(check_frozen(3)).name, "Camera");
}

TEST_F(ReadinessTest, NeedsEnoughMeasuredPixels) {
  const Surface part = [](int u, int, std::uint64_t) { return u < 40 ? wall_px : 0.0; };
  options_.least_measured = 0.251;
  const ReadinessItem problem = only_problem(check(part));
  EXPECT_EQ(problem.name, "Depth");
  EXPECT_THAT(problem.says, AllOf(HasSubstr("25 % of the view is measured: too little"), HasSubstr("lens")));
  EXPECT_EQ(problem.code, "depth-missing");
  EXPECT_EQ(problem.values.at("measured"), 0.25);
  options_.least_measured = 0.25;
  EXPECT_TRUE(check(part).ready());
}

TEST_F(ReadinessTest, OfACameraWhoseDepthDriftsIsNot) {
  for (const double px_per_frame : {0.01, -0.01}) {
    const ReadinessItem problem = only_problem(check(drifting(px_per_frame)));
    EXPECT_EQ(problem.name, "Warm-up");
    // Both halves are four frames apart: 0.04 px of 10.6 px m, at one metre.
    EXPECT_THAT(problem.says, AllOf(HasSubstr("moved by 3.7"), HasSubstr("Wait a few minutes")));
    EXPECT_EQ(problem.code, "camera-drifting");
    EXPECT_NEAR(problem.values.at("drift_mm"), 3.77, 0.05);
  }
  options_.most_drift_px = 0.05;
  EXPECT_TRUE(check(drifting(0.01)).ready()) << "as much is allowed";
}

TEST_F(ReadinessTest, OfANoisyCameraIsNotSpoiledByItsNoise) {
  auto random = std::make_shared<Random>(1);
  options_.most_drift_px = 0.0;
  int ready = 0;
  for (int i = 0; i < 10; ++i) {
    ready += check([random](int, int, std::uint64_t) { return wall_px + 0.2 * random->normal(); }).ready();
  }
  EXPECT_GE(ready, 8) << "three deviations are exceeded in 0.3 %";
}

TEST_F(ReadinessTest, OfACameraBeforeWhichAHandPassesIsReady) {
  const Surface hand = [](int u, int, std::uint64_t frame) {
    return u < 50 && frame % 8 < 4 ? 2.0 * wall_px : wall_px;
  };
  EXPECT_TRUE(check(hand).ready());
}

TEST_F(ReadinessTest, OfACameraThatFailsNamesTheFailure) {
  const Readiness readiness =
      check([](int, int, std::uint64_t) -> double { throw Error("camera", "was unplugged", "plug it in"); });
  const ReadinessItem problem = only_problem(readiness);
  EXPECT_EQ(problem.name, "Camera");
  EXPECT_THAT(problem.says, AllOf(HasSubstr("was unplugged"), HasSubstr("plug it in")));
  EXPECT_EQ(problem.code, "camera-failed");
  EXPECT_EQ(readiness.items.size(), 3U) << "nothing is stated about depth; robot and disk are checked";
}

TEST_F(ReadinessTest, NeedsSpaceOnTheDisk) {
  options_.least_free_gb = 1e6;
  const ReadinessItem problem = only_problem(check(wall));
  EXPECT_EQ(problem.name, "Disk");
  EXPECT_THAT(problem.says, HasSubstr("GB free: at least 1000000.0 GB are needed."));
  EXPECT_EQ(problem.code, "disk-full");
  EXPECT_EQ(problem.values.at("least_free_gb"), 1e6);
}

TEST_F(ReadinessTest, NeedsTheFolder) {
  LiveCamera camera(std::make_unique<KnownCamera>(wall), 500.0);
  const Readiness readiness = check_readiness(camera, nullptr, folder_ / "gone", options_, {});
  const ReadinessItem problem = only_problem(readiness);
  EXPECT_EQ(problem.name, "Disk");
  EXPECT_THAT(problem.says, HasSubstr("cannot be determined: No such file or directory"));
  EXPECT_EQ(problem.code, "disk-unknown");
}

/// A robot whose servos do not answer, until they do.
class MuteRobot : public Robot {
 public:
  [[nodiscard]] RobotLimits limits() const override { return {}; }
  void move_to(const PanTilt& /*target*/) override {}
  [[nodiscard]] PanTilt joints() override {
    if (mute) throw Error("robot", "does not answer", "switch it on");
    return {12.3, -4.5};
  }
  [[nodiscard]] bool moving() override { return false; }
  void stop() override {}

  std::atomic<bool> mute = true;
};

TEST_F(ReadinessTest, NeedsTheRobotsAnswer) {
  MuteRobot robot;
  Drive drive(robot);
  drive_ = &drive;
  ASSERT_TRUE(test::eventually([&] { return !drive.state().problem.empty(); }));
  const ReadinessItem problem = only_problem(check(wall));
  EXPECT_EQ(problem.name, "Robot");
  EXPECT_THAT(problem.says, HasSubstr("does not answer"));
  EXPECT_EQ(problem.code, "robot-failed");
  robot.mute = false;
  ASSERT_TRUE(test::eventually([&] { return drive.state().joints && drive.state().problem.empty(); }));
  const Readiness readiness = check(wall);
  EXPECT_TRUE(readiness.ready());
  EXPECT_EQ(readiness.items.at(3).says, "Connected: pan 12.3, tilt -4.5 degrees.");
  EXPECT_EQ(readiness.items.at(3).code, "robot-ready");
  EXPECT_EQ(readiness.items.at(3).values,
            (std::map<std::string, double>{{"pan_deg", 12.3}, {"tilt_deg", -4.5}}));
}

TEST_F(ReadinessTest, EndsWhenTheUserInterruptsIt) {
  progress_ = [](std::string_view, std::size_t, std::size_t) { throw Interrupted(2); };
  EXPECT_THROW(static_cast<void>(check(wall)), Interrupted);
}

}  // namespace
}  // namespace rva
