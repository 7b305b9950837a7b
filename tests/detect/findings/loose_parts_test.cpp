#include "detect/findings/loose_parts.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>
#include <utility>

#include "core/error.hpp"

namespace rva {
namespace {

const Intrinsics camera{160, 120, 150.0, 150.0, 79.5, 59.5};
constexpr float floor_m = 0.3F;  // a pixel is 2 mm wide there
constexpr float part_m = 0.01F;

Image<float> floor_with(const std::vector<Box>& parts, float height_m = part_m) {
  Image<float> depth_m(camera.width, camera.height, floor_m);
  for (const Box& part : parts) {
    for (int v = part.y; v < part.y + part.height; ++v) {
      for (int u = part.x; u < part.x + part.width; ++u) depth_m(u, v) = floor_m - height_m;
    }
  }
  return depth_m;
}

Detection detection_of(const Image<float>& before_m, const Image<float>& after_m) {
  Comparison comparison(camera.width, camera.height);
  comparison.initial_m = before_m;
  comparison.final_m = after_m;
  for (std::size_t i = 0; i < before_m.size(); ++i) {
    if (before_m[i] == after_m[i]) continue;
    comparison.changed[i] = mask_set;
    comparison.farther[i] = after_m[i] > before_m[i] ? mask_set : 0;
    comparison.evidence[i] = 5.0F;
  }
  Detection detection;
  detection.findings.findings = find_findings(comparison, {}, camera);
  detection.initial_m = before_m;
  detection.final_m = after_m;
  return detection;
}

std::vector<LoosePart> parts_of(const Image<float>& before_m, const Image<float>& after_m,
                                double reach_mm = LoosePartOptions{}.reach_mm) {
  return find_loose_parts(detection_of(before_m, after_m), camera, {.reach_mm = reach_mm});
}

TEST(LooseParts, APartThatMovedIsOnePair) {
  const auto parts = parts_of(floor_with({{60, 40, 10, 10}}), floor_with({{75, 40, 10, 10}}));
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_NEAR(parts[0].moved_at_most_mm(), 30.0, 1.5);
  EXPECT_EQ(direction_of(parts[0]), "to the right");
}

TEST(LooseParts, CrescentsAreOnePairAtTheWidthOfThePart) {
  const auto parts = parts_of(floor_with({{60, 40, 10, 10}}), floor_with({{60, 43, 10, 10}}));
  ASSERT_EQ(parts.size(), 1U);
  EXPECT_NEAR(parts[0].moved_at_most_mm(), 20.0, 1.5) << "it moved by 6 mm, and is 20 mm wide";
  EXPECT_EQ(direction_of(parts[0]), "down");
}

TEST(LooseParts, AnExchangeOfTheCapturesMirrorsTheMotion) {
  const Image<float> one = floor_with({{60, 40, 10, 10}, {100, 80, 6, 12}});
  const Image<float> other = floor_with({{54, 46, 10, 10}, {110, 80, 6, 12}});
  const auto there = parts_of(one, other);
  const auto back = parts_of(other, one);
  ASSERT_FALSE(there.empty());
  ASSERT_EQ(there.size(), back.size());
  for (std::size_t k = 0; k < there.size(); ++k) {
    EXPECT_EQ(there[k].apart_mm, -back[k].apart_mm);
    EXPECT_EQ(there[k].size_mm, back[k].size_mm);
  }
}

TEST(LooseParts, DebrisOfUnlikeSizeIsNotOnePart) {
  EXPECT_TRUE(parts_of(floor_with({{60, 40, 6, 6}}), floor_with({{75, 40, 20, 20}})).empty());
  EXPECT_TRUE(parts_of(floor_with({{60, 40, 10, 10}}, 0.005F), floor_with({{75, 40, 10, 10}}, 0.03F)).empty())
      << "of unlike height";
}

TEST(LooseParts, ArePairedWithinReachAlone) {
  const Image<float> before_m = floor_with({{20, 40, 10, 10}});
  const Image<float> after_m = floor_with({{75, 40, 10, 10}});
  EXPECT_TRUE(parts_of(before_m, after_m).empty()) << "110 mm apart";
  EXPECT_EQ(parts_of(before_m, after_m, 150.0).size(), 1U);
}

TEST(LooseParts, WhereNothingMovedThereAreNone) {
  const Image<float> same_m = floor_with({{60, 40, 10, 10}});
  EXPECT_TRUE(parts_of(same_m, same_m).empty());
  EXPECT_TRUE(parts_of(floor_with({}), same_m).empty()) << "an object that only appeared has no counterpart";
}

TEST(LooseParts, RefuseAReachThatIsNone) {
  const Image<float> same_m = floor_with({});
  EXPECT_THROW((void)parts_of(same_m, same_m, -1.0), UsageError);
}

TEST(LooseParts, AreAddedToTheFindingsAndRemoveNone) {
  const Detection detection =
      detection_of(floor_with({{60, 40, 10, 10}}), floor_with({{75, 40, 10, 10}, {20, 90, 20, 20}}));
  nlohmann::ordered_json json = json_of(detection.findings);
  const nlohmann::ordered_json plain = json;
  const auto parts = find_loose_parts(detection, camera, {});
  ASSERT_EQ(parts.size(), 1U);
  add_loose_parts(parts, json);
  ASSERT_EQ(json["loose_parts"].size(), 1U);
  EXPECT_EQ(json["loose_parts"][0]["direction"], "to the right");
  int of_the_part = 0;
  for (nlohmann::ordered_json& finding : json["detections"]) {
    of_the_part += finding.contains("loose_part") ? 1 : 0;
    finding.erase("loose_part");
  }
  EXPECT_EQ(of_the_part, 2);
  EXPECT_EQ(json["detections"], plain["detections"]);
}

}  // namespace
}  // namespace rva
