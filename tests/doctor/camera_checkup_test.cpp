#include "doctor/camera_checkup.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/random.hpp"
#include "tests/doctor/items.hpp"

namespace rva {
namespace {

using test::item;
using test::state;
using testing::HasSubstr;

/// A camera with the faults that a test chooses, in front of a wall at 0.8 m.
struct Faults {
  double noise_px = 0.05;
  double unmeasured = 0.0;  // share of the image
  double rate_hz = 30.0;
  std::uint64_t lost = 0;  // after the fifth frame
  int frames_until_silence = 1000;
  std::string firmware = "5.15.1.0";
  bool frozen = false;
};

class FaultyCamera : public Camera {
 public:
  explicit FaultyCamera(Faults faults) : faults_(std::move(faults)) {}
  [[nodiscard]] CaptureInfo info() const override {
    CaptureInfo info;
    info.format = "rva-capture";
    info.depth = {width, height, 212.0, 212.0, 79.5, 59.5};
    info.depth_unit_m = 0.0001;
    info.camera = CameraInfo{"D435", "123", baseline_m, faults_.firmware};
    return info;
  }
  [[nodiscard]] std::optional<CameraFrame> wait_for_frame() override {
    if (static_cast<int>(number_) >= faults_.frames_until_silence)
      throw Error("camera", "has given no frame for five seconds", "check its cable, or connect it again");
    DepthImage depth(width, height);
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) depth(u, v) = depth_at(u);
    }
    if (faults_.frozen && number_ > 0)
      depth = first_;
    else
      first_ = depth;
    const std::uint64_t number = number_++;
    return CameraFrame{std::move(depth), std::nullopt, number > 4 ? number + faults_.lost : number,
                       static_cast<double>(number) / faults_.rate_hz};
  }

 private:
  static constexpr int width = 160;
  static constexpr int height = 120;
  static constexpr double baseline_m = 0.05;

  std::uint16_t depth_at(int u) {
    if (u < faults_.unmeasured * width) return no_depth;
    const double disparity_px = 212.0 * baseline_m / 0.8 + faults_.noise_px * random_.normal();
    return static_cast<std::uint16_t>(212.0 * baseline_m / disparity_px / 0.0001);
  }

  Faults faults_;
  std::uint64_t number_ = 0;
  DepthImage first_;
  Random random_{7};
};

CheckedItems examine(const Faults& faults, const DoctorOptions& options = {}) {
  return examine_camera([&] { return std::make_unique<FaultyCamera>(faults); }, {options, 30.0, true}, {});
}

Faults with(const std::function<void(Faults&)>& change) {
  Faults faults;
  change(faults);
  return faults;
}

TEST(CameraCheckup, FindsNothingWrongWithASoundCamera) {
  const CheckedItems items = examine({});
  for (const std::string& name : camera_check_names()) EXPECT_EQ(state(items, name), "ok") << name;
  EXPECT_NEAR(item(items, "noise").values.at("noise_px"), 0.05, 0.003);
  EXPECT_NEAR(item(items, "frame-rate").values.at("rate_hz"), 30.0, 0.01);
  EXPECT_EQ(item(items, "fill").values.at("measured"), 1.0);
}

TEST(CameraCheckup, FindsTooMuchNoise) {
  EXPECT_EQ(state(examine(with([](Faults& faults) { faults.noise_px = 0.15; })), "noise"), "warning");
  const CheckedItems items = examine(with([](Faults& faults) { faults.noise_px = 0.8; }));
  EXPECT_EQ(state(items, "noise"), "failed");
  EXPECT_NEAR(item(items, "noise").values.at("noise_px"), 0.8, 0.05);
}

TEST(CameraCheckup, FindsThatTheCameraIsSilent) {
  for (const int frames : {0, 20}) {
    const CheckedItems items = examine(with([&](Faults& faults) { faults.frames_until_silence = frames; }));
    EXPECT_EQ(state(items, "camera"), "failed");
    EXPECT_THAT(item(items, "camera").result, HasSubstr("no frame for five seconds"));
    EXPECT_EQ(state(items, "noise"), "not-tried");
    EXPECT_EQ(items.size(), camera_check_names().size());
  }
}

TEST(CameraCheckup, FindsAFrozenImage) {
  const CheckedItems items = examine(with([](Faults& faults) { faults.frozen = true; }));
  EXPECT_EQ(state(items, "noise"), "failed");
  EXPECT_EQ(state(items, "fill"), "not-tried");
}

TEST(CameraCheckup, FindsAnImageWithHoles) {
  EXPECT_EQ(state(examine(with([](Faults& faults) { faults.unmeasured = 0.45; })), "fill"), "warning");
  EXPECT_EQ(state(examine(with([](Faults& faults) { faults.unmeasured = 0.75; })), "fill"), "failed");
  const CheckedItems items = examine(with([](Faults& faults) { faults.unmeasured = 1.0; }));
  EXPECT_EQ(state(items, "fill"), "failed");
  EXPECT_EQ(state(items, "noise"), "not-tried");
}

TEST(CameraCheckup, FindsThatFramesAreSlowOrLost) {
  EXPECT_EQ(state(examine(with([](Faults& faults) { faults.rate_hz = 20.0; })), "frame-rate"), "warning");
  EXPECT_EQ(state(examine(with([](Faults& faults) { faults.rate_hz = 6.0; })), "frame-rate"), "failed");
  const CheckedItems items = examine(with([](Faults& faults) { faults.lost = 3; }));
  EXPECT_EQ(state(items, "frame-rate"), "warning");
  EXPECT_EQ(item(items, "frame-rate").values.at("lost_frames"), 3.0);
}

TEST(CameraCheckup, FindsOldFirmware) {
  for (const char* const old : {"5.12.7.100", "5.13.0.49", "5.9", "unknown"})
    EXPECT_EQ(state(examine(with([&](Faults& faults) { faults.firmware = old; })), "camera-firmware"),
              "warning")
        << old;
  EXPECT_EQ(state(examine(with([](Faults& faults) { faults.firmware = ""; })), "camera-firmware"),
            "not-tried");
}

TEST(CameraCheckup, FailsWithTheReasonWhyTheCameraCannotBeOpened) {
  const CheckedItems items = examine_camera(
      []() -> std::unique_ptr<Camera> { throw Error("realsense", "none is plugged in", "plug one in"); },
      {{}, 30.0, true}, {});
  EXPECT_EQ(state(items, "camera"), "failed");
  EXPECT_EQ(item(items, "camera").advice, "plug one in");
  EXPECT_THROW(static_cast<void>(examine_camera(
                   []() -> std::unique_ptr<Camera> { throw UsageError("x", "is no camera", "give one"); },
                   {{}, 30.0, true}, {})),
               UsageError);
}

}  // namespace
}  // namespace rva
