#include "detect/findings/height_above_surroundings.hpp"

#include <gtest/gtest.h>

#include <array>
#include <functional>
#include <nlohmann/json.hpp>

#include "core/random.hpp"
#include "detect/findings/findings.hpp"

namespace rva {
namespace {

constexpr int width = 160;
constexpr int height = 120;
constexpr double noise_m = 0.0005;

const Intrinsics camera{width, height, 212.0, 212.0, 79.5, 59.5};

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
  [[nodiscard]] std::optional<HeightAboveSurroundings> measure() const {
    return height_above_surroundings(pixels, {with_object_m, without_m}, changed, camera);
  }
  [[nodiscard]] std::optional<double> measure_mm() const {
    const std::optional<HeightAboveSurroundings> above = measure();
    return above ? std::optional(above->median_mm) : std::nullopt;
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

// A quarter of the object is higher than the rest.
TEST(HeightAboveSurroundings, HasATopThatIsHigherThanTheMedian) {
  Scene stepped(middle, 10.0, wall, wall);
  for (std::size_t k = 0; k < stepped.pixels.size(); k += 4)
    stepped.with_object_m[stepped.pixels[k]] -= 0.02F;
  const std::optional<HeightAboveSurroundings> above = stepped.measure();
  ASSERT_TRUE(above);
  EXPECT_NEAR(above->median_mm, 10.0, 1.0);
  ASSERT_TRUE(above->top_mm);
  EXPECT_NEAR(*above->top_mm, 30.0, 1.5);
  EXPECT_FALSE(above->at_least) << "all of it and of its surroundings is seen";
}

TEST(HeightAboveSurroundings, IsALeastHeightWhereSomethingIsNotSeen) {
  const auto top = [](int, int) { return 0.7; };
  const auto at_least = [](const Scene& scene) {
    const std::optional<HeightAboveSurroundings> above = scene.measure();
    return above && above->top_mm && above->at_least;
  };
  EXPECT_TRUE(at_least(Scene({0, 50, 20, 12}, 20.0, wall, wall))) << "it may continue beyond the image";
  EXPECT_TRUE(at_least(Scene({70, 50, 20, 12}, 30.0, table, top)))
      << "half of its surroundings is the ground";
  Scene holes(middle, 20.0, wall, wall);
  for (std::size_t k = 0; k < holes.pixels.size(); k += 4) holes.with_object_m[holes.pixels[k]] = 0.0F;
  EXPECT_TRUE(at_least(holes)) << "its top may be in the holes";
  Scene blind(middle, 20.0, wall, wall);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < 80; ++u) {
      if (blind.changed(u, v) == 0) blind.with_object_m(u, v) = 0.0F;
    }
    for (int u = 80; u < width; u += 5) {
      if (blind.changed(u, v) == 0) blind.with_object_m(u, v) = 0.0F;
    }
  }
  EXPECT_FALSE(at_least(blind)) << "what it hides has been seen";
  for (const std::uint32_t i : blind.pixels) blind.without_m[i] = 0.0F;
  EXPECT_TRUE(at_least(blind)) << "its surroundings alone are known, and in part";
  EXPECT_FALSE(at_least(Scene(middle, 20.0, floor_seen_flatly, floor_seen_flatly)));
}

// The plane's normal is found from three of its points in space.
TEST(HeightAboveSurroundings, HasATopAtRightAnglesToItsSurface) {
  const auto point = [](int u, int v) {
    return camera.deproject({static_cast<double>(u), static_cast<double>(v)}, floor_seen_flatly(u, v));
  };
  const Eigen::Vector3d a = point(20, 30);
  const Eigen::Vector3d normal = (point(130, 30) - a).cross(point(20, 90) - a).normalized();
  const Scene on_floor(middle, 40.0, floor_seen_flatly, floor_seen_flatly);
  const std::optional<HeightAboveSurroundings> above = on_floor.measure();
  ASSERT_TRUE(above && above->top_mm);
  EXPECT_LT(std::abs(normal.z()), 0.7) << "it is seen flatly";
  // 40 mm along z at each pixel, which is not along its ray.
  const Eigen::Vector3d ray = point(80, 56) / point(80, 56).z();
  EXPECT_NEAR(*above->top_mm, 40.0 * std::abs(normal.dot(ray)), 2.0);
  EXPECT_NEAR(above->median_mm, 40.0, 1.0);
  EXPECT_FALSE(above->at_least);
}

TEST(HeightAboveSurroundings, HasATopAboveWhatIsSeenWithoutItInAPit) {
  const auto pit = [](int u, int v) { return u > 64 && u < 96 && v > 44 && v < 68 ? 0.9 : 0.8; };
  const std::optional<HeightAboveSurroundings> above = Scene(middle, 15.0, pit, pit).measure();
  ASSERT_TRUE(above && above->top_mm);
  EXPECT_NEAR(above->median_mm, 15.0, 1.0);
  EXPECT_NEAR(*above->top_mm, 15.0, 2.0);
  EXPECT_FALSE(above->at_least);
}

TEST(ReachesBorder, WhereAnImageIsNotJudged) {
  const auto reaches = [](int u, int v) {
    const std::array pixels{static_cast<std::uint32_t>(60 * width + 80),
                            static_cast<std::uint32_t>(v * width + u)};
    return reaches_border(pixels, width, height);
  };
  EXPECT_FALSE(reaches(80, 61));
  EXPECT_FALSE(reaches(7, 60) || reaches(width - 8, 60) || reaches(80, 7) || reaches(80, height - 8));
  EXPECT_TRUE(reaches(6, 60) && reaches(width - 7, 60) && reaches(80, 6) && reaches(80, height - 7));
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
  EXPECT_EQ(json["top_above_surroundings_mm"], *flat.top_above_surroundings_mm);
  EXPECT_EQ(json["top_is_least"], false);
  findings.findings[0].above_surroundings_mm.reset();
  findings.findings[0].top_above_surroundings_mm.reset();
  for (const char* const member : {"background_jump", "top_is_least"})
    EXPECT_FALSE(json_of(findings)["detections"][0].contains(member)) << member;
}

}  // namespace
}  // namespace rva
