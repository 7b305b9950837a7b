#include "inspect/baseline_check.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>

#include "capture/folder/capture_writer.hpp"
#include "core/file.hpp"
#include "core/interrupt.hpp"
#include "sim/simulated_camera.hpp"
#include "tests/sim/simulated_frames.hpp"
#include "tests/sim/small_scenes.hpp"
#include "tests/temporary_folder.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

/// A room with boxes on its wall, one of which may be missing.
Scene room(bool whole) {
  Scene scene = test::room_with_wall(0.6);
  const Transform world_from_camera =
      SimulatedCamera(scene, test::quick(), 0, ColorFrames::none).world_from_camera();
  const auto add = [&](double x_m, double y_m, double side_m) {
    scene.objects.push_back(test::box_at("box", world_from_camera * Eigen::Vector3d(x_m, y_m, 0.58),
                                         {side_m, 0.04, side_m}, test::grainy));
  };
  add(-0.08, -0.05, 0.05);
  add(0.07, 0.06, 0.04);
  if (whole) add(0.05, -0.05, 0.04);
  return scene;
}

class BaselineCheck : public ::testing::Test {
 protected:
  BaselineCheck() {
    inspection_.id = 1;
    inspection_.views = {PanTilt{}};
    inspection_.dither = 4;
  }

  void capture(int number, const Scene& scene) {
    const fs::path capture = folder_.capture(Side::initial, inspection_, 0, number);
    fs::create_directories(capture);
    SimulatedCamera camera(scene, test::quick(), static_cast<std::uint64_t>(number), ColorFrames::none);
    CaptureWriter writer(capture, camera.info());
    constexpr std::size_t frames = 4;
    for (std::size_t i = 0; i < frames; ++i) writer.write_depth(i, camera.wait_for_frame()->depth);
  }

  // The box is there in the second half alone, or in both.
  void capture_all(bool whole_at_first = true) {
    for (int k = 0; k < inspection_.dither; ++k)
      capture(k, room(2 * k < inspection_.dither ? whole_at_first : true));
  }

  [[nodiscard]] nlohmann::json view() const {
    return nlohmann::json::parse(read_text_file(folder_.baseline_check() / "check.json"))["views"][0];
  }

  test::TemporaryFolder data_;
  InspectionFolder folder_{data_.path(), 1};
  Inspection inspection_;
};

TEST_F(BaselineCheck, OfWhatStaysTheSameFindsNothingAndStatesLevels) {
  capture_all();
  check_baseline(folder_, inspection_, {});
  EXPECT_EQ(view()["false_findings"], 0);
  ASSERT_FALSE(view()["level_of_detection"]["by_distance"].empty());
  const double level_mm = view()["level_of_detection"]["by_distance"][0]["median_mm"];
  EXPECT_GT(level_mm, 0.1);
  EXPECT_LT(level_mm, 20.0);
  const nlohmann::json findable = view()["level_of_detection"]["findable"];
  ASSERT_EQ(findable.size(), 3U);
  EXPECT_EQ(findable[0]["size_mm"], 5.0);
  EXPECT_LE(findable[0]["share"], findable[2]["share"]);
  EXPECT_GT(findable[2]["share"], 0.1);
  EXPECT_TRUE(fs::exists(folder_.baseline_check() / "000" / "level_of_detection.png"));
}

TEST_F(BaselineCheck, OfWhatChangesMeanwhileShowsIt) {
  capture_all(false);
  check_baseline(folder_, inspection_, {});
  EXPECT_GE(view()["false_findings"], 1);
  EXPECT_TRUE(fs::exists(folder_.baseline_check() / "000" / "depth_overlay.png"));
}

TEST_F(BaselineCheck, StatesWhyAViewCannotBeCompared) {
  capture_all();
  fs::remove_all(folder_.capture(Side::initial, inspection_, 0, 3) / "depth");
  check_baseline(folder_, inspection_, {});
  EXPECT_FALSE(view()["problem"].get<std::string>().empty());
  EXPECT_FALSE(view().contains("false_findings"));
}

TEST_F(BaselineCheck, IsMadeOnceAndOfFourCapturesAtLeast) {
  inspection_.dither = 2;
  capture_all();
  check_baseline(folder_, inspection_, {});
  EXPECT_FALSE(fs::exists(folder_.baseline_check()));
  inspection_.dither = 4;
  fs::create_directories(folder_.baseline_check());
  check_baseline(folder_, inspection_, {});
  EXPECT_TRUE(fs::is_empty(folder_.baseline_check())) << "what is there stays as it is";
}

TEST_F(BaselineCheck, ThatIsEndedLeavesNothing) {
  capture_all();
  const Progress end = [](std::string_view, std::size_t, std::size_t) { throw Interrupted(0); };
  EXPECT_THROW(check_baseline(folder_, inspection_, end), Interrupted);
  for (const fs::directory_entry& entry : fs::directory_iterator(folder_.path()))
    EXPECT_EQ(entry.path().filename(), "initial");
}

}  // namespace
}  // namespace rva
