#include "sim/simulated_capture.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <nlohmann/json.hpp>

#include "capture/capture.hpp"
#include "core/file.hpp"
#include "core/output_folder.hpp"
#include "tests/sim/small_scenes.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

TEST(SimulatedCapture, StatesHowItWasSimulated) {
  const test::TemporaryFolder folder;
  SimulatedCamera camera(test::room_with_wall(1.0), {}, 7, ColorFrames::none);
  OutputFolder out(folder / "capture", simulated_capture_files(), Existing::refuse);
  write_simulated_capture(camera, {.debris = "none"}, {.frames = 2, .infrared = true}, out, {});
  out.commit();
  EXPECT_EQ(open_capture(folder / "capture")->depth_frames(), 2U);
  for (const char* const file : {"truth/truth.json", "infrared/left.png", "infrared/right.png"})
    EXPECT_TRUE(std::filesystem::exists(folder / "capture" / file)) << file;
  EXPECT_TRUE(holds_only(folder / "capture", simulated_capture_files()));
  const auto simulation =
      nlohmann::json::parse(read_text_file(folder / "capture" / "capture.json"))["simulation"];
  EXPECT_EQ(simulation["scene"], "room");
  EXPECT_EQ(simulation["seed"], 7);
  EXPECT_EQ(simulation["camera_model"], "d435");
  EXPECT_EQ(simulation["debris"], "none");
  EXPECT_FALSE(simulation.contains("debris_seed"));
  EXPECT_TRUE(simulation["options"].is_object());
}

}  // namespace
}  // namespace rva
