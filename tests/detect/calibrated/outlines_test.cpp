#include "detect/calibrated/outlines.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>
#include <vector>

namespace rva {
namespace {

constexpr int width = 80;
constexpr int height = 60;
constexpr double tests = 4.0;
constexpr double slope = 1.5;

/// As many peaks as are learnt from make the tail an exponential one: 100 exp(-1.5 (height - 3)).
const FalseAlarmTail exponential(100.0, slope, 1e9);

/// The rarity of pooled evidence by that formula.
double rarity(double deviations) {
  return -std::log10(tests * 100.0) + slope * (deviations - FalseAlarmTail::onset) / std::log(10.0);
}

struct Square {
  int left = 0;
  int top = 0;
  int size = 0;
  float evidence = 0.0F;

  [[nodiscard]] bool contains(int u, int v) const {
    return u >= left && u < left + size && v >= top && v < top + size;
  }
};

Image<float> evidence_of(const std::vector<Square>& squares) {
  Image<float> evidence(width, height);
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u) {
      for (const Square& square : squares) {
        if (square.contains(u, v)) evidence(u, v) = square.evidence;
      }
    }
  }
  return evidence;
}

Scale scale_at(const Image<float>& evidence, int window_px, double threshold) {
  return {pool(evidence, Mask(width, height, mask_set), window_px, 1.0),
          {exponential, exponential},
          {threshold, threshold}};
}

class OutlinesTest : public testing::Test {
 protected:
  /// The changes that the given scales show.
  void add(const Scale& scale, const Image<float>& evidence) { outlines_.add(scale, evidence); }

  void expect_changed(const std::vector<Square>& squares) const {
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        bool inside = false;
        for (const Square& square : squares) inside = inside || square.contains(u, v);
        EXPECT_EQ(comparison_.changed(u, v) != 0, inside) << u << ", " << v;
        if (!inside) {
          EXPECT_EQ(comparison_.evidence(u, v), 0.0F);
        }
      }
    }
  }

  Mask unreliable_{width, height};
  Comparison comparison_{width, height};
  Outlines outlines_{unreliable_, tests, comparison_};
};

constexpr Square bolt{30, 20, 9, 4.0F};

TEST_F(OutlinesTest, OfAChangeIsItsPixels) {
  const Image<float> evidence = evidence_of({bolt});
  add(scale_at(evidence, 9, 20.0), evidence);
  expect_changed({bolt});
  EXPECT_EQ(comparison_.farther(34, 24), 0);
  // 81 pixels of 4 deviations each are 36 deviations of their sum.
  EXPECT_NEAR(comparison_.evidence(34, 24), rarity(36.0), 1e-3);
  EXPECT_NEAR(comparison_.evidence(30, 20), rarity(36.0), 1e-3) << "also in the corner";
}

TEST_F(OutlinesTest, OfAChangeAwayFromTheCameraIsTheSameAndFarther) {
  const Image<float> evidence = evidence_of({{30, 20, 9, -4.0F}});
  add(scale_at(evidence, 9, 20.0), evidence);
  expect_changed({bolt});
  EXPECT_EQ(comparison_.farther(34, 24), mask_set);
  EXPECT_NEAR(comparison_.evidence(34, 24), rarity(36.0), 1e-3);
}

TEST_F(OutlinesTest, NeedMoreThanTheThreshold) {
  const Image<float> evidence = evidence_of({bolt});
  add(scale_at(evidence, 9, 36.001), evidence);
  expect_changed({});
}

TEST_F(OutlinesTest, ThresholdsAreThoseOfThePixelsClass) {
  const Image<float> evidence = evidence_of({bolt, {60, 20, 9, 4.0F}});
  for (int v = 0; v < height; ++v)
    for (int u = 50; u < width; ++u) unreliable_(u, v) = mask_set;
  Scale scale = scale_at(evidence, 9, 20.0);
  scale.thresholds.unreliable = 40.0;
  add(scale, evidence);
  expect_changed({bolt});
}

TEST_F(OutlinesTest, HaveMoreThanHalfOfTheMeanEvidence) {
  const Square above{39, 20, 3, 2.1F};
  const Square below{27, 20, 3, 1.9F};
  const Image<float> evidence = evidence_of({bolt, above, below});
  const Scale scale = scale_at(evidence, 9, 20.0);
  ASSERT_NEAR(scale.evidence.deviations(34, 24), 36.0F, 1e-4) << "beside them, no window has more evidence";
  add(scale, evidence);
  expect_changed({bolt, above});
}

TEST_F(OutlinesTest, OfTheFinestScaleStayWhileCoarserOnesMakeThemRarer) {
  const Square halo{26, 16, 17, 2.5F};
  const Image<float> fine = evidence_of({bolt});
  const Image<float> coarse = evidence_of({halo, bolt});
  add(scale_at(fine, 9, 20.0), fine);
  const float before = comparison_.evidence(34, 24);
  add(scale_at(coarse, 17, 30.0), coarse);
  expect_changed({bolt});
  EXPECT_GT(comparison_.evidence(34, 24), before + 1.0F);
  const float most = comparison_.evidence(34, 24);
  add(scale_at(fine, 9, 20.0), fine);
  EXPECT_EQ(comparison_.evidence(34, 24), most) << "never less rare";
}

TEST_F(OutlinesTest, OfAChangeThatOnlyACoarseScaleShowsAreItsPixels) {
  const Square rag{10, 30, 25, 0.9F};
  const Image<float> evidence = evidence_of({{50, 10, 9, 4.0F}, rag});
  add(scale_at(evidence, 9, 20.0), evidence);
  expect_changed({{50, 10, 9, 4.0F}});
  add(scale_at(evidence, 25, 20.0), evidence);
  expect_changed({{50, 10, 9, 4.0F}, rag});
}

TEST_F(OutlinesTest, OfOppositeChangesAreKeptApart) {
  const Square key{30, 20, 9, 4.0F};
  const Square gap{39, 20, 9, -5.0F};
  const Image<float> evidence = evidence_of({key, gap});
  add(scale_at(evidence, 5, 15.0), evidence);
  expect_changed({key, gap});
  EXPECT_EQ(comparison_.farther(38, 24), 0);
  EXPECT_EQ(comparison_.farther(39, 24), mask_set);
  EXPECT_NEAR(comparison_.evidence(34, 24), rarity(5 * 4.0), 1e-3);
  EXPECT_NEAR(comparison_.evidence(43, 24), rarity(5 * 5.0), 1e-3);
  const Image<float> other = evidence_of({{26, 16, 17, -6.0F}});
  add(scale_at(other, 17, 20.0), other);
  EXPECT_NEAR(comparison_.evidence(34, 24), rarity(5 * 4.0), 1e-3) << "it is not made rarer by its opposite";
}

TEST_F(OutlinesTest, AtTheBorderOfTheImageAreWithinIt) {
  const Square corner{0, 0, 9, 4.0F};
  const Image<float> evidence = evidence_of({corner});
  add(scale_at(evidence, 9, 20.0), evidence);
  expect_changed({corner});
}

}  // namespace
}  // namespace rva
