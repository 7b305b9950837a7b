#include "camera/noise_files.hpp"

#include <gtest/gtest.h>

#include <filesystem>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/file.hpp"
#include "core/json_object.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

Noise some_noise() {
  Noise noise{Image<float>(64, 48, 1.5F), Image<float>(64, 48, 0.5F), {}};
  noise.welch_p[1] = 0.001F;
  noise.welch_p[2] = std::numeric_limits<float>::quiet_NaN();
  noise.report.frames = 8;
  noise.report.alpha = 0.01;
  noise.report.overall = {0.5, 1.5, 64 * 48, 1.5, 1.6, {}};
  noise.report.bins = {noise.report.overall};
  return noise;
}

TEST(NoiseFiles, ShowDriftInWhiteAndWhatWasNotTestedInGrey) {
  const GrayImage picture = drift_picture(some_noise());
  EXPECT_EQ(picture[0], 0);
  EXPECT_EQ(picture[1], mask_set);
  EXPECT_EQ(picture[2], 96);
}

TEST(NoiseFiles, LeaveOutWhatIsUnknown) {
  const auto json = json_of(some_noise().report);
  EXPECT_EQ(json["format"], "rva-noise");
  EXPECT_EQ(json["by_distance"][0]["median_std_mm"], 1.5);
  EXPECT_FALSE(json["overall"].contains("subpixel_rms_px"));
  EXPECT_FALSE(json["welch"].contains("rejected")) << "no pixel was tested";
}

TEST(NoiseFiles, AreWrittenIntoAResultFolder) {
  const test::TemporaryFolder folder;
  OutputFolder out(folder / "noise", noise_files(), Existing::refuse);
  write_noise(some_noise(), out);
  out.commit();
  EXPECT_TRUE(holds_only(folder / "noise", noise_files()));
  EXPECT_EQ(read_text_file(folder / "noise" / "noise.json"), json_file_text(json_of(some_noise().report)));
  for (const std::string& file : noise_files())
    EXPECT_TRUE(std::filesystem::exists(folder / "noise" / file)) << file;
}

}  // namespace
}  // namespace rva
