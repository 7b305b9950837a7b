#include "detect/spatial/lit_capture.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

#include "capture/memory_capture.hpp"

namespace rva {
namespace {

constexpr int width = 120;
constexpr int height = 90;
constexpr int lit_px = 70;  ///< columns that dots fall on
constexpr std::uint16_t depth_mm = 500;

FineGrayImage dots_on_the_left(int columns = lit_px) {
  constexpr int apart_px = 9;
  constexpr auto bright = static_cast<std::uint16_t>(120 * fine_steps_per_grey_level);
  FineGrayImage image(width, height);
  for (int v = 2; v < height - 1; v += apart_px) {
    for (int u = 2; u < columns - 1; u += apart_px) image(u, v) = image(u + 1, v) = image(u, v + 1) = bright;
  }
  return image;
}

std::unique_ptr<Capture> capture_with(std::map<Imager, FineGrayImage> infrared) {
  CaptureInfo info;
  info.depth = {.width = width, .height = height, .fx = 100.0, .fy = 100.0, .cx = 59.5, .cy = 44.5};
  info.depth_unit_m = 0.001;
  if (!infrared.empty()) info.infrared = InfraredBurst{};
  std::vector<MemoryFrame> frames;
  frames.push_back({DepthImage(width, height, depth_mm), {}, std::move(infrared), {}});
  return std::make_unique<MemoryCapture>(std::move(info), std::move(frames));
}

Captures one(std::map<Imager, FineGrayImage> infrared) {
  Captures captures;
  captures.push_back(capture_with(std::move(infrared)));
  return captures;
}

TEST(LitCapture, LacksDepthBeyondTheProjectorsLight) {
  const Captures captures = one({{Imager::left, dots_on_the_left()}});
  const LitSides lit = within_projector_field(captures, captures);
  ASSERT_EQ(lit.final.size(), 1U);
  const DepthImage depth = lit.final.front()->depth(0);
  EXPECT_EQ(depth(30, 45), depth_mm);
  EXPECT_EQ(depth(100, 45), 0);
  EXPECT_EQ(captures.front()->depth(0)(100, 45), depth_mm) << "the capture itself stays";
  EXPECT_TRUE(lit.final.front()->has_infrared(Imager::left, Light::projector));
  EXPECT_EQ(lit.final.front()->info().depth, captures.front()->info().depth);
}

TEST(LitCapture, LacksWhatTheOtherSideOfTheSamePoseLacks) {
  const Captures initial = one({{Imager::left, dots_on_the_left()}});
  const Captures final = one({{Imager::left, dots_on_the_left(width)}});
  const LitSides lit = within_projector_field(initial, final);
  EXPECT_EQ(lit.initial.front()->depth(0)(100, 45), 0);
  EXPECT_EQ(lit.final.front()->depth(0)(100, 45), 0);
  EXPECT_EQ(lit.final.front()->depth(0)(30, 45), depth_mm);
}

TEST(LitCapture, WithoutInfraredImagesIsAsItWas) {
  const Captures captures = one({});
  const Captures others = one({{Imager::left, dots_on_the_left()}});
  const DepthImage depth = within_projector_field(captures, others).initial.front()->depth(0);
  EXPECT_TRUE(std::ranges::equal(depth.pixels(), captures.front()->depth(0).pixels()));
}

}  // namespace
}  // namespace rva
