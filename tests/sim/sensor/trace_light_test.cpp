#include "sim/sensor/trace_light.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "scene/ray_caster.hpp"
#include "scene/traces.hpp"
#include "scene/wing/wing_bay.hpp"

namespace rva {
namespace {

const Eigen::Vector3f middle{0.1F, 0.3F, 0.002F};

Trace trace(TraceKind kind, float contrast) { return {kind, middle, Eigen::Vector3f::UnitX(), contrast}; }

// The least and the greatest factor of light within a square with sides of `side_m`, centred on `about`.
std::pair<float, float> least_and_most(const std::vector<Trace>& traces, const Eigen::Vector3f& about,
                                       float side_m) {
  constexpr int steps = 40;
  float least = 10.0F;
  float most = 0.0F;
  for (int i = 0; i <= steps; ++i) {
    for (int k = 0; k <= steps; ++k) {
      const Eigen::Vector3f off(static_cast<float>(i) / steps - 0.5F, static_cast<float>(k) / steps - 0.5F,
                                0.0F);
      const float light = trace_light(traces, about + side_m * off);
      least = std::min(least, light);
      most = std::max(most, light);
    }
  }
  return {least, most};
}

TEST(TraceLight, ChangesTheLightByItsContrastAtMostAndOneWayOnly) {
  for (const TraceKind kind : {TraceKind::dust, TraceKind::smear, TraceKind::fingerprint}) {
    const auto [darkest, bright] = least_and_most({trace(kind, -0.1F)}, middle, 0.01F);
    EXPECT_GE(darkest, 0.9F - 1e-5F);
    EXPECT_LT(darkest, 0.95F);
    EXPECT_LE(bright, 1.0F);
    const auto [dark, brightest] = least_and_most({trace(kind, 0.1F)}, middle, 0.01F);
    EXPECT_GE(dark, 1.0F);
    EXPECT_GT(brightest, 1.05F);
  }
}

TEST(TraceLight, BeyondTracesIsAsItWas) {
  const std::vector<Trace> traces{trace(TraceKind::dust, 0.1F), trace(TraceKind::smear, -0.1F)};
  EXPECT_EQ(least_and_most(traces, middle + Eigen::Vector3f(0.2F, 0.0F, 0.0F), 0.1F), std::pair(1.0F, 1.0F));
  EXPECT_EQ(trace_light({}, middle), 1.0F);
}

TEST(TraceLight, ASmearLiesAlongItsDirection) {
  const std::vector<Trace> smear{trace(TraceKind::smear, -0.15F)};
  EXPECT_LT(trace_light(smear, middle + Eigen::Vector3f(0.03F, 0.0F, 0.0F)), 0.98F);
  EXPECT_EQ(trace_light(smear, middle + Eigen::Vector3f(0.0F, 0.03F, 0.0F)), 1.0F);
}

TEST(Traces, LieOnSurfacesOfTheBayAndFollowFromTheirSeed) {
  Scene scene;
  scene.objects = build_wing_bay({});
  scene.bay = inside_of({});
  Scene again = scene;
  const TraceCounts counts{.dust = 2, .smears = 3, .fingerprints = 4, .seed = 5};
  leave_traces(counts, scene);
  leave_traces(counts, again);
  ASSERT_GE(scene.traces.size(), 7U);
  const RayCaster rays(scene);
  for (std::size_t i = 0; i < scene.traces.size(); ++i) {
    const Trace& left = scene.traces[i];
    EXPECT_EQ(left.at_m, again.traces[i].at_m);
    const auto hit =
        rays.cast(Ray{left.at_m + Eigen::Vector3f(0.0F, 0.0F, 0.001F), -Eigen::Vector3f::UnitZ()});
    ASSERT_TRUE(hit);
    EXPECT_NEAR(hit->distance, 0.001F, 1e-4F);
    EXPECT_GE(std::abs(left.contrast), 0.03F);
  }
}

}  // namespace
}  // namespace rva
