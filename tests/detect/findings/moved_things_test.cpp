#include "detect/findings/moved_things.hpp"

#include <gtest/gtest.h>

#include "detect/findings/findings.hpp"

namespace rva {
namespace {

const Intrinsics camera{160, 120, 150.0, 150.0, 79.5, 59.5};
constexpr float floor_m = 1.0F;

struct Thing {
  Box box;
  float height_m = 0.03F;
};

// A floor seen from above, from which one thing was taken and onto which another was put.
Comparison moved(const Thing& removed, const Thing& added) {
  Comparison comparison(camera.width, camera.height);
  comparison.initial_m = comparison.final_m = Image<float>(camera.width, camera.height, floor_m);
  const auto put = [&](const Thing& thing, Image<float>& depth_m, std::uint8_t farther) {
    for (int v = thing.box.y; v < thing.box.y + thing.box.height; ++v) {
      for (int u = thing.box.x; u < thing.box.x + thing.box.width; ++u) {
        depth_m(u, v) -= thing.height_m;
        comparison.changed(u, v) = mask_set;
        comparison.farther(u, v) = farther;
        comparison.evidence(u, v) = 5.0F;
      }
    }
  };
  put(removed, comparison.initial_m, mask_set);
  put(added, comparison.final_m, 0);
  return comparison;
}

// Whether the added finding names the removed one.
bool recognised(const Thing& removed, const Thing& added) {
  const std::vector<Finding> findings = find_findings(moved(removed, added), {}, camera);
  EXPECT_EQ(findings.size(), 2U);
  for (const Finding& finding : findings) {
    if (finding.kind == ChangeKind::removed) {
      EXPECT_FALSE(finding.moved_from) << "only what was added has come from somewhere";
    } else if (finding.moved_from) {
      EXPECT_EQ(findings.at(static_cast<std::size_t>(*finding.moved_from - 1)).kind, ChangeKind::removed);
      return true;
    }
  }
  return false;
}

TEST(MovedThings, AreRecognisedBySizeWhicheverWayTheyAreTurned) {
  const Thing there{{20, 30, 30, 12}};
  EXPECT_TRUE(recognised(there, {{100, 60, 30, 12}}));
  EXPECT_TRUE(recognised(there, {{100, 60, 12, 30}}));
  EXPECT_TRUE(recognised(there, {{50, 30, 30, 12}})) << "beside where it was";
  EXPECT_TRUE(recognised(there, {{100, 60, 31, 13}})) << "outlines are uncertain by a pixel";
}

TEST(MovedThings, OfAnotherSizeAreOtherThings) {
  const Thing there{{20, 30, 30, 12}};
  EXPECT_FALSE(recognised(there, {{100, 60, 40, 12}}));
  EXPECT_FALSE(recognised(there, {{100, 60, 30, 20}}));
  EXPECT_FALSE(recognised(there, {{100, 60, 30, 12}, 0.06F})) << "twice as high";
  EXPECT_FALSE(recognised({{60, 40, 24, 30}}, {{84, 44, 20, 24}})) << "another one beside";
}

TEST(MovedThings, EachIsNamedOnce) {
  Comparison comparison = moved({{20, 30, 20, 12}}, {{100, 60, 20, 12}});
  for (int v = 90; v < 102; ++v) {
    for (int u = 20; u < 40; ++u) {
      comparison.final_m(u, v) -= 0.03F;
      comparison.changed(u, v) = mask_set;
      comparison.evidence(u, v) = 5.0F;
    }
  }
  int named = 0;
  for (const Finding& finding : find_findings(comparison, {}, camera)) named += finding.moved_from ? 1 : 0;
  EXPECT_EQ(named, 1);
}

}  // namespace
}  // namespace rva
