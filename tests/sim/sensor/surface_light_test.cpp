#include "sim/sensor/surface_light.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "core/random.hpp"

namespace rva {
namespace {

const Eigen::Vector3f up = Eigen::Vector3f::UnitZ();

Material material(double specular, int gloss) { return {"test", 0.5, specular, gloss, 0.0, 0.001, Rgb{}}; }

/// In the plane of x and z, from the normal towards x.
Eigen::Vector3f direction(double angle_deg) {
  const double angle = angle_deg * std::numbers::pi / 180.0;
  return Eigen::Vector3d(std::sin(angle), 0.0, std::cos(angle)).cast<float>();
}

SurfacePoint seen_from(const Eigen::Vector3f& to_eye) { return {Eigen::Vector3f::Zero(), up, to_eye}; }

Eigen::Vector3f random_direction(Random& random) {
  const double height = random.uniform(0.05, 1.0);
  const double turn = random.uniform(0.0, 2.0 * std::numbers::pi);
  const double flat = std::sqrt(1.0 - height * height);
  return Eigen::Vector3d(flat * std::cos(turn), flat * std::sin(turn), height).cast<float>();
}

TEST(SurfaceLight, AWhiteMattSurfaceHeadOnGivesOne) {
  EXPECT_FLOAT_EQ(reflected(material(0, 1), 1.0F, seen_from(up), up), 1.0F);
  EXPECT_FLOAT_EQ(reflected(material(0, 1), 1.0F, seen_from(direction(70)), up), 1.0F);
  EXPECT_FLOAT_EQ(reflected_surroundings(material(0, 1), 1.0F, seen_from(up)), 1.0F);
}

TEST(SurfaceLight, MattFollowsTheCosine) {
  for (double angle_deg = -85.0; angle_deg < 90.0; angle_deg += 5.0) {
    const auto expected = static_cast<float>(0.3 * std::cos(angle_deg * std::numbers::pi / 180.0));
    EXPECT_NEAR(reflected(material(0, 1), 0.3F, seen_from(up), direction(angle_deg)), expected, 1e-6F);
  }
}

TEST(SurfaceLight, NothingComesFromBehind) {
  for (const double angle_deg : {90.001, 95.0, 135.0, 180.0, -120.0}) {
    EXPECT_EQ(reflected(material(0, 1), 1.0F, seen_from(up), direction(angle_deg)), 0.0F);
    EXPECT_EQ(reflected(material(0.9, 5), 1.0F, seen_from(direction(80)), direction(angle_deg)), 0.0F);
  }
}

TEST(SurfaceLight, EyeAndLightMayChangePlaces) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const Material glossy = material(random.uniform(), static_cast<int>(random.uniform(1, 200)));
    const Eigen::Vector3f a = random_direction(random);
    const Eigen::Vector3f b = random_direction(random);
    const float there = reflected(glossy, 0.4F, seen_from(a), b) / b.z();
    const float back = reflected(glossy, 0.4F, seen_from(b), a) / a.z();
    EXPECT_NEAR(there, back, 1e-3F * there);
  }
}

TEST(SurfaceLight, TheHighlightIsWhereAMirrorWouldShowTheLight) {
  for (const double light_deg : {-50.0, -20.0, 0.0, 35.0}) {
    double best_deg = -90.0;
    float brightest = 0.0F;
    for (double eye_deg = -85.0; eye_deg <= 85.0; eye_deg += 0.5) {
      const float light =
          reflected(material(0.5, 90), 0.2F, seen_from(direction(eye_deg)), direction(light_deg));
      if (light > brightest) best_deg = eye_deg;
      brightest = std::max(brightest, light);
    }
    EXPECT_NEAR(best_deg, -light_deg, 0.51);
  }
}

TEST(SurfaceLight, MoreGlossIsASmallerAndBrighterHighlight) {
  const auto at = [](int gloss, double eye_deg) {
    return reflected(material(0.3, gloss), 0.0F, seen_from(direction(eye_deg)), up);
  };
  EXPECT_GT(at(100, 0), at(10, 0));
  EXPECT_LT(at(100, 40), at(10, 40));
}

// Over all directions of the eye, what leaves is the share that arrives; Blinn's lobe is normalised so.
TEST(SurfaceLight, GlossGivesBackItsShareOfTheLight) {
  for (const int gloss : {20, 100}) {
    Random random(2);
    double sum = 0.0;
    constexpr int directions = 200000;
    for (int i = 0; i < directions; ++i) {
      const double height = std::sqrt(random.uniform());  // as many as the cosine weighs
      const double flat = std::sqrt(1.0 - height * height);
      const Eigen::Vector3f to_eye = Eigen::Vector3d(flat, 0.0, height).cast<float>();
      sum += static_cast<double>(reflected(material(0.5, gloss), 0.0F, seen_from(to_eye), up));
    }
    EXPECT_NEAR(sum / directions, 0.5, 0.05) << gloss;
  }
}

TEST(SurfaceLight, OnlyAGlossySurfaceChangesWithTheEye) {
  const SurfacePoint here = seen_from(direction(10));
  const SurfacePoint there = seen_from(direction(40));
  EXPECT_EQ(reflected_surroundings(material(0, 1), 0.5F, here),
            reflected_surroundings(material(0, 1), 0.5F, there));
  EXPECT_NE(reflected_surroundings(material(0.5, 50), 0.5F, here),
            reflected_surroundings(material(0.5, 50), 0.5F, there));
}

}  // namespace
}  // namespace rva
