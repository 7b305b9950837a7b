#include "detect/findings/height_above_surroundings.hpp"

#include <gtest/gtest.h>

#include <functional>
#include <nlohmann/json.hpp>

#include "core/random.hpp"
#include "detect/findings/findings.hpp"

namespace rva {
namespace {

constexpr int width = 160;
constexpr int height = 120;
constexpr double noise_m = 0.0005;

/// Depth at a pixel, metres.
using Surface = std::function<double(int u, int v)>;

double wall(int /*u*/, int /*v*/) { return 0.8; }

/// A plane in space that recedes towards the top of the image: from 0.5 to 1 m.
double floor_seen_flatly(int /*u*/, int v) { return 1.0 / (1.0 + (v + 1.0) / height); }

/// A table of which the upper half is missing: the ground is 250 mm farther.
double table(int /*u*/, int v) { return v < height / 2 ? 0.95 : 0.7; }

/// A box in the image that stands out of `under` by `height_mm`, with what is measured where it is and is
/// not.
struct Scene {
  Scene(const Box& box, double height_mm, const Surface& before, const Surface& under)
      : changed(width, height), with_object_m(width, height), without_m(width, height) {
    Random random(3);
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        const bool inside = u >= box.x && u < box.x + box.width && v >= box.y && v < box.y + box.height;
        const double after_m = inside ? under(u, v) - height_mm / 1000.0 : before(u, v);
        without_m(u, v) = static_cast<float>(before(u, v) + noise_m * random.normal());
        with_object_m(u, v) = static_cast<float>(after_m + noise_m * random.normal());
        if (!inside) continue;
        changed(u, v) = mask_set;
        pixels.push_back(static_cast<std::uint32_t>(v * width + u));
      }
    }
  }
  [[nodiscard]] std::optional<double> measure_mm() const {
    return height_above_surroundings_mm(pixels, {with_object_m, without_m}, changed);
  }

  Mask changed;
  Image<float> with_object_m;
  Image<float> without_m;
  std::vector<std::uint32_t> pixels;
};

constexpr Box middle{70, 50, 20, 12};

TEST(HeightAboveSurroundings, IsThatOfAnObjectOnAPlane) {
  for (const Surface& plane : {Surface(wall), Surface(floor_seen_flatly)}) {
    for (const double height_mm : {4.0, 15.0, 40.0}) {
      const std::optional<double> measured_mm = Scene(middle, height_mm, plane, plane).measure_mm();
      ASSERT_TRUE(measured_mm) << height_mm;
      EXPECT_NEAR(*measured_mm, height_mm, 1.0);
    }
  }
}

// It lies on the table's edge, half of it before the ground.
TEST(HeightAboveSurroundings, IsThatAboveTheNearestSurfaceAtAnEdge) {
  const auto top = [](int, int) { return 0.7; };
  for (const int y : {50, 54, 58}) {
    const Scene edge({70, y, 20, 12}, 30.0, table, top);
    const std::optional<double> measured_mm = edge.measure_mm();
    ASSERT_TRUE(measured_mm) << y;
    EXPECT_NEAR(*measured_mm, 30.0, 1.0) << y;
  }
}

TEST(HeightAboveSurroundings, IsMeasuredAtTheBorderOfTheImage) {
  for (const Box& box : {Box{0, 0, 15, 15}, Box{140, 100, 20, 20}, Box{0, 50, 160, 8}}) {
    const std::optional<double> measured_mm =
        Scene(box, 20.0, floor_seen_flatly, floor_seen_flatly).measure_mm();
    ASSERT_TRUE(measured_mm) << box.x;
    EXPECT_NEAR(*measured_mm, 20.0, 1.5) << box.x;
  }
}

TEST(HeightAboveSurroundings, IsUnknownWithoutMeasurements) {
  Scene blind_ring(middle, 20.0, wall, wall);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      if (blind_ring.changed(u, v) == 0 && u % 4 != 0) blind_ring.with_object_m(u, v) = 0.0F;
    }
  }
  EXPECT_FALSE(blind_ring.measure_mm());
  Scene blind_object(middle, 20.0, wall, wall);
  for (std::size_t k = 0; k < blind_object.pixels.size(); ++k) {
    if (k % 5 < 3) blind_object.with_object_m[blind_object.pixels[k]] = 0.0F;
  }
  EXPECT_FALSE(blind_object.measure_mm());
  EXPECT_FALSE(Scene({0, 0, width, height}, 20.0, wall, wall).measure_mm()) << "nothing is around it";
}

TEST(HeightAboveSurroundings, IsUnknownOfWhatDoesNotStandOut) {
  EXPECT_FALSE(Scene(middle, -20.0, wall, wall).measure_mm());
}

TEST(HeightAboveSurroundings, IgnoresTheSurfacesOfOtherFindings) {
  Scene beside_another(middle, 20.0, wall, wall);
  for (int v = 40; v < 80; ++v) {
    for (int u = 94; u < 130; ++u) {
      beside_another.with_object_m(u, v) -= 0.015F;
      beside_another.changed(u, v) = mask_set;
    }
  }
  EXPECT_NEAR(*beside_another.measure_mm(), 20.0, 1.0);
}

TEST(HeightAboveSurroundings, NeverExceedsTheChange) {
  // Before, something else lay there, of which the surroundings show nothing.
  const auto with_pad = [](int u, int v) { return u > 65 && u < 95 && v > 45 && v < 67 ? 0.77 : 0.8; };
  EXPECT_NEAR(*Scene(middle, 12.0, with_pad, with_pad).measure_mm(), 12.0, 1.0);
}

TEST(BackgroundJump, IsMuchMoreThanTheHeight) {
  EXPECT_TRUE(is_background_jump(157.0, 30.0));
  EXPECT_FALSE(is_background_jump(30.0, 30.0));
  EXPECT_FALSE(is_background_jump(8.0, 1.0)) << "a few millimetres are within the noise";
}

/// The finding of a comparison in which the scene's object is there after, or before.
Finding finding_of(const Scene& scene, bool added) {
  Comparison comparison(width, height);
  comparison.changed = scene.changed;
  if (!added) comparison.farther = scene.changed;
  comparison.final_m = added ? scene.with_object_m : scene.without_m;
  comparison.initial_m = added ? scene.without_m : scene.with_object_m;
  const Intrinsics camera{width, height, 212.0, 212.0, 79.5, 59.5};
  return find_findings(comparison, {}, camera).at(0);
}

TEST(Findings, HaveAHeightAboveTheirSurroundings) {
  const auto top = [](int, int) { return 0.7; };
  const Scene edge({70, 48, 20, 14}, 30.0, table, top);
  for (const bool added : {true, false}) {
    const Finding finding = finding_of(edge, added);
    EXPECT_NEAR(*finding.above_surroundings_mm, 30.0, 1.0);
    EXPECT_NEAR(*finding.height_mm, added ? 280.0 : -280.0, 1.0);
    EXPECT_TRUE(finding.background_jump);
  }
  const Finding flat = finding_of(Scene(middle, 20.0, wall, wall), true);
  EXPECT_FALSE(flat.background_jump);
  Findings findings;
  findings.findings = {flat};
  const auto json = json_of(findings)["detections"][0];
  EXPECT_EQ(json["above_surroundings_mm"], *flat.above_surroundings_mm);
  EXPECT_EQ(json["background_jump"], false);
  findings.findings[0].above_surroundings_mm.reset();
  EXPECT_FALSE(json_of(findings)["detections"][0].contains("background_jump"));
}

}  // namespace
}  // namespace rva
