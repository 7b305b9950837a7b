#include "detect/findings/findings.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace rva {
namespace {

constexpr int width = 100;
const Intrinsics camera{width, 80, 50.0, 40.0, 49.5, 39.5};

// Two rectangles nearer than a wall at 1 m: one by 100 mm, one by 20 mm.
Comparison sample() {
  Comparison comparison(width, 80);
  comparison.initial_m = comparison.final_m = Image<float>(width, 80, 1.0F);
  comparison.coverage = {0.9, 0.06, 0.04, std::nullopt};
  for (int v = 10; v < 14; ++v) {
    for (int u = 20; u < 30; ++u) {
      comparison.changed(u, v) = mask_set;
      comparison.final_m(u, v) = 0.9F;
      comparison.evidence(u, v) = 2.0F;
      comparison.changed(u + 50, v + 50) = mask_set;
      comparison.final_m(u + 50, v + 50) = 0.98F;
      comparison.evidence(u + 50, v + 50) = 5.0F;
    }
  }
  return comparison;
}

TEST(Findings, AreMeasuredInTheCamerasFrame) {
  const Comparison comparison = sample();
  const std::vector<Finding> findings = find_findings(comparison, {}, camera);
  ASSERT_EQ(findings.size(), 2U);
  const Finding& second = findings[1];
  EXPECT_EQ(second.box, (Box{20, 10, 10, 4}));
  EXPECT_EQ(second.pixels.size(), 40U);
  EXPECT_EQ(second.centroid, Eigen::Vector2d(24.5, 11.5));
  EXPECT_TRUE(second.position_m->isApprox(
      Eigen::Vector3d((24.5 - 49.5) / 50 * 0.9, (11.5 - 39.5) / 40 * 0.9, 0.9), 1e-6));
  EXPECT_NEAR((*second.size_mm)[0], 10 * 900 / 50.0, 1e-3);
  EXPECT_NEAR((*second.size_mm)[1], 4 * 900 / 40.0, 1e-3);
  EXPECT_NEAR(*second.height_mm, 100.0, 1e-3);
}

TEST(Findings, WithoutDepthAfterwardsTheyHaveNoHeight) {
  Comparison lost = sample();
  for (int v = 10; v < 13; ++v) {
    for (int u = 20; u < 30; ++u) lost.final_m(u, v) = 0.0F;
  }
  const Finding went = find_findings(lost, {}, camera)[1];
  EXPECT_FALSE(went.height_mm);
  EXPECT_EQ(went.kind, ChangeKind::added);
  EXPECT_FLOAT_EQ(static_cast<float>(went.position_m->z()), 1.0F) << "three rows of four, as before";
  std::swap(lost.initial_m, lost.final_m);
  lost.farther = lost.changed;
  const Finding came = find_findings(lost, {}, camera)[1];
  EXPECT_FALSE(came.height_mm);
  EXPECT_EQ(came.kind, ChangeKind::removed);
  lost.initial_m = lost.final_m = Image<float>(width, 80);
  const Finding nowhere = find_findings(lost, {}, camera)[1];
  EXPECT_FALSE(nowhere.position_m);
  EXPECT_FALSE(nowhere.size_mm);
}

TEST(Findings, MostSuspiciousComesFirst) {
  const Comparison comparison = sample();
  const std::vector<Finding> findings = find_findings(comparison, {}, camera);
  EXPECT_EQ(findings[0].id, 1);
  EXPECT_EQ(findings[0].box.x, 70);
  EXPECT_GT(*findings[0].score, *findings[1].score);
  EXPECT_FALSE(findings[0].p_value);
}

TEST(Findings, JsonHasTheContractsShape) {
  const Comparison comparison = sample();
  Findings findings;
  findings.method = "gaussian";
  findings.parameters = {{"sigmas", 3.0}};
  findings.initial_frames = 40;
  findings.final_frames = 20;
  findings.coverage = comparison.coverage;
  findings.findings = find_findings(comparison, {}, camera);
  const auto json = json_of(findings);
  EXPECT_EQ(json["format"], "rva-detections");
  EXPECT_EQ(json["version"], 1);
  EXPECT_EQ(json["frames"]["final"], 20);
  EXPECT_EQ(json["final_from_initial"].size(), 16U);
  EXPECT_EQ(json["coverage"]["unseen"], 0.06);
  EXPECT_FALSE(json["coverage"].contains("beyond_clip"));
  EXPECT_TRUE(json["runtime_ms"].contains("total"));
  ASSERT_EQ(json["detections"].size(), 2U);
  const auto& first = json["detections"][0];
  EXPECT_EQ(first["kind"], "added");
  EXPECT_EQ(first["bbox"], (std::vector<int>{70, 60, 10, 4}));
  EXPECT_EQ(first["area_px"], 40);
  EXPECT_FALSE(first.contains("p_value"));
}

}  // namespace
}  // namespace rva
