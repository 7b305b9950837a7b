#include "detect/appearance/color_evidence.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "capture/memory_capture.hpp"
#include "core/error.hpp"
#include "core/random.hpp"
#include "detect/appearance/color_means.hpp"
#include "geometry/stereo_scale.hpp"

namespace rva {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

// A wall before a depth camera, and a colour imager of another focal length beside it.
constexpr double wall_m = 0.6;
const Intrinsics depth_camera{.width = 200, .height = 150, .fx = 250.0, .fy = 250.0, .cx = 99.5, .cy = 74.5};
const Intrinsics color_camera{
    .width = 300, .height = 210, .fx = 400.0, .fy = 400.0, .cx = 149.5, .cy = 104.5};
const Transform color_from_depth(Eigen::Translation3d(0.015, 0.0, 0.0));

using Light3 = std::array<double, 3>;  ///< red, green, blue, 1 is white
using Wall = std::function<Light3(double x_m, double y_m)>;

Light3 painted(double x_m, double y_m) {
  const bool odd =
      (static_cast<int>(std::floor(x_m / 0.03)) + static_cast<int>(std::floor(y_m / 0.04))) % 2 != 0;
  const double paint = (odd ? 0.8 : 1.0) + 0.1 * std::sin(260.0 * x_m) * std::sin(190.0 * y_m + 1.0);
  return {0.3 * paint, 0.4 * paint, 0.35 * paint};
}

// Where the thing lies on the wall, and at which pixel of the depth image.
constexpr double thing_x_m = 0.048;
constexpr double thing_y_m = -0.024;
constexpr int thing_u = 119;  // 99.5 + 250 * 0.048 / 0.6
constexpr int thing_v = 64;   // 74.5 - 250 * 0.024 / 0.6

// As bright as the wall, and redder.
Light3 with_a_red_thing(double x_m, double y_m) {
  Light3 light = painted(x_m, y_m);
  if (std::abs(x_m - thing_x_m) > 0.008 || std::abs(y_m - thing_y_m) > 0.008) return light;
  light[0] *= 1.4;
  light[1] *= 0.94;
  light[2] *= 0.94;
  return light;
}

ColorImage color_of(const Wall& wall, double brightness, Random& random) {
  ColorImage image(color_camera.width, color_camera.height);
  for (int v = 0; v < image.height(); ++v) {
    for (int u = 0; u < image.width(); ++u) {
      const Eigen::Vector3d at = color_from_depth.inverse() * color_camera.deproject({u, v}, wall_m);
      std::array<std::uint8_t, 3> value{};
      const Light3 light = wall(at.x(), at.y());
      for (std::size_t c = 0; c < value.size(); ++c) {
        const double linear = std::clamp(brightness * light[c] * (1.0 + 0.02 * random.normal()), 0.0, 1.0);
        value[c] = static_cast<std::uint8_t>(std::lround(255.0 * std::pow(linear, 1.0 / 2.2)));
      }
      image(u, v) = {value[0], value[1], value[2]};
    }
  }
  return image;
}

CaptureInfo info() {
  CaptureInfo info;
  info.depth = depth_camera;
  info.depth_unit_m = 0.001;
  info.color = color_camera;
  info.color_from_depth = color_from_depth;
  return info;
}

std::unique_ptr<Capture> capture_of(const std::vector<Wall>& walls, std::uint64_t seed,
                                    double brightness = 1.0) {
  Random random(seed);
  std::vector<MemoryFrame> frames;
  for (const Wall& wall : walls)
    frames.push_back({DepthImage(depth_camera.width, depth_camera.height, 600),
                      color_of(wall, brightness, random),
                      {},
                      {}});
  return std::make_unique<MemoryCapture>(info(), std::move(frames));
}

DepthView view() {
  constexpr StereoScale stereo{.focal_baseline_m_px = 12.5};
  constexpr auto disparity_px = static_cast<float>(stereo.disparity_px(wall_m));
  return {depth_camera, stereo, Image<float>(depth_camera.width, depth_camera.height, disparity_px),
          Image<float>(depth_camera.width, depth_camera.height)};
}

std::optional<JudgedChange> compare(const Capture& initial, const Capture& final,
                                    std::vector<std::string>& warnings) {
  return still_color_change_between(initial, final, view(), warnings);
}

float greatest(const JudgedChange& change) {
  float most = 0.0F;
  for (const float deviations : change.change.deviations.pixels())
    most = std::max(most, std::abs(deviations));
  return most;
}

std::ptrdiff_t judged(const JudgedChange& change) {
  return std::ranges::count(change.change.judged.pixels(), mask_set);
}

TEST(ColorEvidence, OfNothingIsWithinNoiseThoughExposureDiffers) {
  for (const double brightness : {1.0, 0.7}) {
    std::vector<std::string> warnings;
    const auto change =
        compare(*capture_of({painted, painted}, 1), *capture_of({painted, painted}, 2, brightness), warnings);
    ASSERT_TRUE(change);
    EXPECT_LT(greatest(*change), 6.0F) << brightness;
    EXPECT_GT(judged(*change), 15000) << brightness;
    EXPECT_THAT(warnings, IsEmpty());
  }
}

TEST(ColorEvidence, OfAThingAsBrightAsWhatItLiesOnIsItsColour) {
  std::vector<std::string> warnings;
  const auto change = compare(*capture_of({painted, painted}, 3),
                              *capture_of({with_a_red_thing, with_a_red_thing}, 4), warnings);
  ASSERT_TRUE(change);
  EXPECT_GT(change->change.deviations(thing_u, thing_v), 12.0F);
  EXPECT_NEAR(change->change.contrast(thing_u, thing_v), std::log(1.4), 0.1);
  for (int v = 0; v < depth_camera.height; ++v) {
    for (int u = 0; u < depth_camera.width; ++u) {
      if (std::max(std::abs(u - thing_u), std::abs(v - thing_v)) <= 8) continue;
      EXPECT_LT(std::abs(change->change.deviations(u, v)), 6.0F) << u << ", " << v;
    }
  }
}

TEST(ColorEvidence, DoesNotJudgeWhatMovesWhileACaptureIsTaken) {
  std::vector<std::string> warnings;
  const auto change = compare(*capture_of({painted, painted}, 5),
                              *capture_of({painted, with_a_red_thing, painted}, 6), warnings);
  ASSERT_TRUE(change);
  EXPECT_EQ(change->change.judged(thing_u, thing_v), 0);
  EXPECT_EQ(change->change.judged(thing_u - 40, thing_v + 40), mask_set);
}

TEST(ColorEvidence, IsNoneInTheDark) {
  std::vector<std::string> warnings;
  const auto dark = [](std::uint64_t seed) { return capture_of({painted}, seed, 0.005); };
  EXPECT_FALSE(compare(*dark(7), *dark(8), warnings));
  EXPECT_FALSE(compare(*capture_of({painted}, 9), *dark(10), warnings));
  EXPECT_THAT(warnings, IsEmpty());
  Captures lit;
  lit.push_back(capture_of({painted}, 11));
  Captures unlit;
  unlit.push_back(dark(12));
  EXPECT_TRUE(have_lit_color(lit, lit));
  EXPECT_FALSE(have_lit_color(lit, unlit));
}

// The shadow of a person: its edge cannot be distinguished from that of an object.
TEST(ColorEvidence, IsNoneWhereTheLightOfAQuarterOfTheViewChanged) {
  const Wall shaded = [](double x_m, double y_m) {
    Light3 light = painted(x_m, y_m);
    for (double& channel : light) channel *= x_m < -0.1 ? 0.5 : 1.0;
    return light;
  };
  std::vector<std::string> warnings;
  const auto change = compare(*capture_of({painted}, 13), *capture_of({shaded}, 14), warnings);
  EXPECT_FALSE(change) << greatest(*change);
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("as when the lighting changed")));
}

TEST(ColorEvidence, ThatCannotBeReadIsNamedAndStopsNothing) {
  class Damaged : public MemoryCapture {
   public:
    using MemoryCapture::MemoryCapture;
    [[nodiscard]] std::optional<ColorImage> color_of(std::size_t /*i*/) const override {
      throw Error("color/000000.jpg", "the file ends early", "record it again");
    }
  };
  Random random(15);
  std::vector<MemoryFrame> frames;
  frames.push_back(
      {DepthImage(depth_camera.width, depth_camera.height, 600), color_of(painted, 1.0, random), {}, {}});
  const Damaged damaged(info(), std::move(frames));
  std::vector<std::string> warnings;
  EXPECT_FALSE(compare(*capture_of({painted}, 16), damaged, warnings));
  EXPECT_THAT(warnings, ElementsAre(HasSubstr("color/000000.jpg: the file ends early")));
}

TEST(ColorEvidence, TakesACaptureThatStatesWhereTheColourImagerStands) {
  EXPECT_TRUE(has_comparable_color(*capture_of({painted}, 17)));
  CaptureInfo unknown = info();
  unknown.color_from_depth.reset();
  std::vector<MemoryFrame> frames;
  frames.push_back({DepthImage(depth_camera.width, depth_camera.height, 600),
                    ColorImage(color_camera.width, color_camera.height),
                    {},
                    {}});
  EXPECT_FALSE(has_comparable_color(MemoryCapture(unknown, frames)));
  CaptureInfo bent = info();
  bent.color->distortion = Distortion::brown_conrady;
  EXPECT_FALSE(has_comparable_color(MemoryCapture(bent, frames)));
  frames.front().color.reset();
  EXPECT_FALSE(has_comparable_color(MemoryCapture(info(), frames)));
}

}  // namespace
}  // namespace rva
