#include "detect/calibrated/scale.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "core/random.hpp"

namespace rva {
namespace {

constexpr int width = 120;
constexpr int height = 90;
constexpr ByReliability<PriorSlope> slopes{{3.0, 10.0}, {2.0, 10.0}};

PooledEvidence white(std::uint64_t seed, int window_px = 5) {
  Image<float> evidence(width, height);
  Random random(seed);
  for (float& pixel : evidence.pixels()) pixel = static_cast<float>(random.normal());
  return pool(evidence, Mask(width, height, mask_set), window_px, 1.0);
}

PooledEvidence negated(PooledEvidence evidence) {
  for (float& deviations : evidence.deviations.pixels()) deviations = -deviations;
  return evidence;
}

/// Every third column.
Mask stripes() {
  Mask mask(width, height);
  for (int v = 0; v < height; ++v)
    for (int u = 0; u < width; u += 3) mask(u, v) = mask_set;
  return mask;
}

bool is_exceeded_around(const PooledEvidence& evidence, int u, int v, float sign) {
  for (int y = std::max(v - evidence.window_px, 0); y <= std::min(v + evidence.window_px, height - 1); ++y) {
    for (int x = std::max(u - evidence.window_px, 0); x <= std::min(u + evidence.window_px, width - 1); ++x) {
      if (sign * evidence.deviations(x, y) > sign * evidence.deviations(u, v)) return true;
    }
  }
  return false;
}

// The definition, pixel by pixel.
std::vector<float> all_peaks(const PooledEvidence& evidence, const Mask& unreliable, bool of_unreliable) {
  std::vector<float> peaks;
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      if ((unreliable(u, v) != 0) != of_unreliable) continue;
      for (const float sign : {1.0F, -1.0F}) {
        const float deviations = sign * evidence.deviations(u, v);
        if (deviations > FalseAlarmTail::onset && !is_exceeded_around(evidence, u, v, sign))
          peaks.push_back(deviations);
      }
    }
  }
  std::ranges::sort(peaks);
  return peaks;
}

std::vector<float> sorted(std::vector<float> values) {
  std::ranges::sort(values);
  return values;
}

TEST(Scale, PeaksAreThosePixelsThatNoOtherExceedsNearby) {
  std::size_t found = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    PooledEvidence evidence = white(seed);
    for (float& deviations : evidence.deviations.pixels()) deviations *= 2.0F;
    const ByReliability<std::vector<float>> peaks = peaks_of(evidence, stripes());
    EXPECT_EQ(sorted(peaks.reliable), all_peaks(evidence, stripes(), false)) << seed;
    EXPECT_EQ(sorted(peaks.unreliable), all_peaks(evidence, stripes(), true)) << seed;
    found += peaks.reliable.size() + peaks.unreliable.size();
  }
  EXPECT_GT(found, 50U);
}

TEST(Scale, HasAFewPeaksBeyondItsThresholdsAsAllowed) {
  constexpr int many = 60;
  constexpr double allowed = 0.5;
  const Mask none(width, height);
  double beyond = 0.0;
  for (std::uint64_t seed = 1; seed <= many; ++seed) {
    const Scale scale = scale_of(white(seed), none, slopes, allowed);
    for (const float peak : peaks_of(scale.evidence, none).reliable)
      beyond += static_cast<double>(peak) > scale.thresholds.reliable ? 0.5 : 0.0;  // of both signs
  }
  EXPECT_GT(beyond, many * allowed / 2.0);
  EXPECT_LT(beyond, many * allowed * 2.0);
}

TEST(Scale, ThresholdsRiseWhereLessIsAllowed) {
  double last = FalseAlarmTail::onset;
  for (const double allowed : {0.5, 0.05, 0.005, 0.0005}) {
    const Scale scale = scale_of(white(3), Mask(width, height), slopes, allowed);
    EXPECT_GT(scale.thresholds.reliable, last);
    EXPECT_NEAR(scale.tails.reliable.expected_above(scale.thresholds.reliable), allowed, 1e-6 * allowed);
    last = scale.thresholds.reliable;
  }
}

TEST(Scale, OfNegatedEvidenceIsTheSame) {
  const Scale scale = scale_of(white(4), stripes(), slopes, 0.01);
  const Scale turned = scale_of(negated(white(4)), stripes(), slopes, 0.01);
  EXPECT_DOUBLE_EQ(scale.thresholds.reliable, turned.thresholds.reliable);
  EXPECT_DOUBLE_EQ(scale.thresholds.unreliable, turned.thresholds.unreliable);
}

// Of noise with larger tails, more is required.
TEST(Scale, LearnsTheTailsOfEachClassOfPixels) {
  Mask left_half(width, height);
  PooledEvidence evidence = white(5);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width / 2; ++u) {
      left_half(u, v) = mask_set;
      evidence.deviations(u, v) *= 2.0F;
    }
  }
  const Scale scale = scale_of(evidence, left_half, {{3.0, 10.0}, {3.0, 10.0}}, 0.01);
  EXPECT_GT(scale.thresholds.unreliable, scale.thresholds.reliable + 1.0);
}

TEST(Scale, OfNothingHasThePriorsThresholds) {
  const PooledEvidence nothing = pool(Image<float>(width, height), Mask(width, height), 5);
  const Scale scale = scale_of(nothing, Mask(width, height), slopes, 0.01);
  const FalseAlarmTail prior = fit_tail({}, slopes.reliable);
  EXPECT_DOUBLE_EQ(scale.thresholds.reliable, prior.height_of(0.01));
  EXPECT_TRUE(std::isfinite(scale.thresholds.unreliable));
}

}  // namespace
}  // namespace rva
