#include "report/object_groups.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <vector>

namespace rva {
namespace {

ReviewedFinding finding(int number, int same_as, std::optional<int> clear_px = std::nullopt) {
  ReviewedFinding reviewed;
  reviewed.number = number;
  reviewed.same_as = same_as;
  reviewed.clear_px = clear_px;
  return reviewed;
}

TEST(ObjectGroups, JoinWhatShowsOneObject) {
  const std::vector<ReviewedFinding> findings{finding(1, 1, 10), finding(2, 2), finding(3, 1, 30),
                                              finding(4, 4), finding(5, 1, 30)};
  const std::vector<ObjectGroup> groups = object_groups(findings);
  ASSERT_EQ(groups.size(), 3U);
  EXPECT_EQ(groups[0].lead, findings.data());
  EXPECT_THAT(groups[0].all, testing::ElementsAre(&findings[0], &findings[2], &findings[4]));
  EXPECT_EQ(groups[1].label, 2);
  EXPECT_EQ(groups[2].label, 3);
  EXPECT_EQ(&best_seen(groups[0]), &findings[2]) << "the first of those that are seen equally well";
  EXPECT_EQ(&best_seen(groups[1]), &findings[1]) << "of an earlier version, which does not state it";
  EXPECT_TRUE(object_groups({}).empty());
}

TEST(ObjectGroups, EachObjectIsCountedOnceByItsVerdict) {
  std::vector<ReviewedFinding> findings{finding(1, 1), finding(2, 1), finding(3, 3)};
  findings[0].decision = findings[1].decision = Decision{Verdict::installed_work, "", "", "", 0};
  const VerdictCounts counts = verdicts_of(findings);
  EXPECT_EQ(counts.installed, 1U);
  EXPECT_EQ(counts.undecided, 1U);
  EXPECT_EQ(counts.all(), 2U);
}

}  // namespace
}  // namespace rva
