#include "plan/plan_match.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <nlohmann/json.hpp>
#include <set>

#include "core/random.hpp"
#include "tests/plan/planned_floor.hpp"

namespace rva {
namespace {

using test::add_finding;
using test::clean_floor;
using test::matched;
using testing::ElementsAre;
using testing::IsEmpty;

constexpr int part_px = 8;
constexpr double part_mm = 9.0;

// Four collars in a row, 20 pixels (40 mm) apart.
const std::string row =
    "  - { name: collars, height_mm: [8, 10], size_mm: [8, 16], areas: [[[10, 30], [110, 30], [110, 70], "
    "[10, "
    "70]]], places: [[30, 50], [50, 50], [70, 50], [90, 50]] }\n";
const std::string count_only =
    "  - { name: nuts, count: 3, height_mm: [8, 10], size_mm: [8, 16], areas: [[[10, 30], [110, 30], [110, "
    "70], "
    "[10, 70]]] }\n";

Box box_at(int u, int v) { return {u - part_px / 2, v - part_px / 2, part_px, part_px}; }

void add_row(const std::vector<int>& columns, Detection& detection) {
  for (const int u : columns) add_finding(box_at(u, 50), part_mm, detection);
}

PlannedState state_of(const PlanMatch& match, int id) {
  return std::ranges::find(match.findings, id, &PlannedFinding::id)->state;
}

std::vector<int> places_of(const std::vector<AbsentPart>& parts) {
  std::vector<int> places;
  for (const AbsentPart& part : parts) places.push_back(part.place.value_or(0));
  return places;
}

TEST(PlanMatch, GroupsWhatWasPlanned) {
  Detection detection = clean_floor();
  add_row({30, 50, 70, 90}, detection);
  const PlanMatch match = matched(row, detection);
  ASSERT_EQ(match.groups.size(), 1U);
  EXPECT_EQ(match.groups.front().found, 4);
  EXPECT_THAT(match.groups.front().findings, ElementsAre(1, 2, 3, 4));
  EXPECT_THAT(match.groups.front().missing, IsEmpty());
  EXPECT_THAT(match.unplanned, IsEmpty());
  EXPECT_THAT(match.surplus, IsEmpty());
}

TEST(PlanMatch, ListsWhatIsMissingAndWhatWasNotPlannedFirst) {
  Detection detection = clean_floor();
  add_row({30, 50, 90}, detection);
  add_finding(box_at(150, 90), part_mm, detection);
  const PlanMatch match = matched(row, detection);
  EXPECT_EQ(match.groups.front().found, 3);
  EXPECT_THAT(places_of(match.groups.front().missing), ElementsAre(3));
  ASSERT_EQ(match.unplanned.size(), 1U);
  EXPECT_EQ(match.unplanned.front().finding, 4);
  EXPECT_EQ(match.findings.front().id, 4);
}

TEST(PlanMatch, AMissingPartIsNoneWhereTheViewWasNotInspected) {
  Detection detection = clean_floor();
  add_row({30, 50}, detection);
  Image<float>& least_mm = detection.level_of_detection->least_mm;
  for (int v = 0; v < least_mm.height(); ++v) {
    for (int u = 60; u < 80; ++u) least_mm(u, v) = std::numeric_limits<float>::quiet_NaN();
    for (int u = 80; u < 100; ++u) least_mm(u, v) = 12.0F;  // a lower part would not have been found
  }
  const PlannedGroup group = matched(row, detection).groups.front();
  EXPECT_THAT(group.missing, IsEmpty());
  EXPECT_THAT(places_of(group.not_inspected), ElementsAre(3, 4));
}

TEST(PlanMatch, ASurplusPartIsNamed) {
  Detection detection = clean_floor();
  add_row({30, 50, 70, 90}, detection);
  add_finding(box_at(60, 64), part_mm, detection);
  const PlanMatch match = matched(row, detection);
  EXPECT_EQ(match.groups.front().found, 4);
  ASSERT_EQ(match.surplus.size(), 1U);
  EXPECT_EQ(match.surplus.front().finding, 5);
  EXPECT_EQ(match.surplus.front().item, "collars");
}

// Each of the pair is nearest to the place in the middle; a greedy choice would leave one of them over.
TEST(PlanMatch, FindsAsManyPartsAsPossible) {
  Detection detection = clean_floor();
  add_finding(box_at(51, 50), part_mm, detection);
  add_finding(box_at(57, 62), part_mm, detection);
  const PlanMatch match = matched(
      "  - { name: a, height_mm: [8, 10], places: [[48, 50], [54, 56]], tolerance_mm: 15 }\n", detection);
  EXPECT_EQ(match.groups.front().found, 2);
  EXPECT_THAT(match.surplus, IsEmpty());
}

TEST(PlanMatch, AFindingOfSeveralPartsCountsAsThese) {
  Detection detection = clean_floor();
  Finding finding;
  finding.id = 1;
  for (const int u : {30, 50, 70}) test::raise(box_at(u, 50), part_mm, finding, detection);
  detection.findings.findings.push_back(finding);
  const PlanMatch match = matched(row, detection);
  EXPECT_EQ(match.groups.front().found, 3);
  EXPECT_THAT(match.groups.front().findings, ElementsAre(1));
}

TEST(PlanMatch, OnePieceOnSeveralPlacesCountsAsThese) {
  Detection detection = clean_floor();
  add_finding({46, 46, 28, 8}, part_mm, detection);
  const PlanMatch match = matched(row, detection);
  EXPECT_EQ(match.groups.front().found, 2);
  EXPECT_EQ(state_of(match, 1), PlannedState::planned);
}

TEST(PlanMatch, OnePieceOfAnAreaCountsAsManyAsItIsLarge) {
  Detection detection = clean_floor();
  add_row({30}, detection);
  add_finding({56, 46, 2 * part_px, part_px}, part_mm, detection);
  const PlanMatch match = matched(
      "  - { name: nuts, count: 3, height_mm: [8, 10], size_mm: [4, 6], areas: [[[10, 30], [110, 30], [110, "
      "70], "
      "[10, 70]]] }\n",
      detection);
  EXPECT_EQ(match.groups.front().found, 3);
}

TEST(PlanMatch, AnObjectLostAmongPlannedPartsOfTheSameFindingIsNotHidden) {
  Detection detection = clean_floor();
  Finding finding;
  finding.id = 1;
  for (const int u : {30, 50}) test::raise(box_at(u, 50), part_mm, finding, detection);
  test::raise(box_at(40, 80), part_mm, finding, detection);
  detection.findings.findings.push_back(finding);
  const PlanMatch match = matched(row, detection);
  EXPECT_EQ(match.groups.front().found, 2);
  ASSERT_EQ(match.unplanned.size(), 1U);
  EXPECT_EQ(match.unplanned.front().box, box_at(40, 80));
  EXPECT_EQ(state_of(match, 1), PlannedState::unplanned);
}

TEST(PlanMatch, WhatIsTooHighTooLargeOrOfTheOtherKindIsNotPlanned) {
  for (const auto& [box, height_mm] : {std::pair{box_at(40, 50), 30.0}, std::pair{box_at(40, 50), -30.0},
                                       std::pair{Box{30, 32, 36, 36}, part_mm}}) {
    Detection detection = clean_floor();
    add_finding(box, height_mm, detection);
    const PlanMatch match = matched(count_only, detection);
    EXPECT_EQ(match.groups.front().found, 0) << height_mm;
    EXPECT_EQ(match.unplanned.size(), 1U) << height_mm;
  }
}

TEST(PlanMatch, SomethingLargeUponAPlaceIsSurplus) {
  Detection detection = clean_floor();
  add_finding({30, 30, 40, 40}, part_mm, detection);
  const PlanMatch match = matched(row, detection);
  EXPECT_EQ(state_of(match, 1), PlannedState::surplus);
  EXPECT_EQ(match.surplus.size(), 1U);
}

TEST(PlanMatch, HeightsMayBeWrongByTheLevelOfDetection) {
  Detection detection = clean_floor();
  add_finding(box_at(30, 50), 25.0, detection);
  EXPECT_EQ(matched(count_only, detection).groups.front().found, 0);
  for (float& level_mm : detection.level_of_detection->least_mm.pixels()) level_mm = 20.0F;
  EXPECT_EQ(matched(count_only, detection).groups.front().found, 1);
}

// The matcher does not resolve what is smaller than its window: at its place, it may have any depth.
TEST(PlanMatch, OfASmallPieceAtAPlaceTheHeightDoesNotMatter) {
  Detection small = clean_floor();
  add_finding(box_at(30, 50), -25.0, small);
  EXPECT_EQ(matched(row, small).groups.front().found, 1);
  Detection large = clean_floor();
  add_finding({23, 43, 14, 14}, -25.0, large);
  EXPECT_EQ(matched(row, large).groups.front().found, 0);
}

TEST(PlanMatch, ATinyPieceIsAPartAtItsPlaceOnly) {
  Detection detection = clean_floor();
  add_finding({30, 50, 1, 1}, part_mm, detection);
  EXPECT_EQ(matched(row, detection).groups.front().found, 1);
  const PlanMatch counted = matched(count_only, detection);
  EXPECT_EQ(counted.groups.front().found, 0);
  EXPECT_EQ(counted.unplanned.size(), 1U);
}

TEST(PlanMatch, ASecondPieceWithinAPartBelongsToIt) {
  Detection detection = clean_floor();
  add_row({30}, detection);
  add_finding({29, 46, 4, 8}, -part_mm, detection);
  EXPECT_THAT(matched(row, detection).groups.front().findings, ElementsAre(1, 2));
  add_finding(box_at(37, 50), part_mm, detection);  // too far from the place to be within the part
  EXPECT_THAT(matched(row, detection).surplus, testing::SizeIs(1));
}

// Small pieces beside a part come from the matcher's window; whole parts are never taken for such pieces.
TEST(PlanMatch, ASmallPieceBesideAPartBelongsToIt) {
  Detection detection = clean_floor();
  add_row({30}, detection);
  add_finding({36, 48, 2, 2}, part_mm, detection);
  const PlanMatch match = matched(row, detection);
  EXPECT_EQ(match.groups.front().found, 1);
  EXPECT_THAT(match.groups.front().findings, ElementsAre(1, 2));
  EXPECT_THAT(match.surplus, IsEmpty());
}

/// Changes by chance: near the row, beside it and far from it.
Detection random_floor(std::uint64_t seed) {
  Random random(seed);
  Detection detection = clean_floor();
  for (const int u : {30, 50, 70, 90}) {
    if (random.uniform() < 0.8)
      add_finding(box_at(u + static_cast<int>(random.bits() % 5U) - 2, 50), part_mm, detection);
  }
  for (int k = 0; k < 4; ++k)
    add_finding(box_at(120 + 20 * k, 20 + static_cast<int>(random.bits() % 80U)), random.uniform(2.0, 20.0),
                detection);
  add_finding(box_at(20 + static_cast<int>(random.bits() % 80U), 35), part_mm, detection);
  return detection;
}

TEST(PlanMatch, DoesNotDependOnTheOrderOfTheFindings) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Detection detection = random_floor(seed);
    for (const std::string& plan : {row, count_only}) {
      const PlanMatch match = matched(plan, detection);
      Detection reversed = detection;
      std::ranges::reverse(reversed.findings.findings);
      const PlanMatch other = matched(plan, reversed);
      nlohmann::ordered_json a = json_of(match);
      nlohmann::ordered_json b = json_of(other);
      a.erase("order");  // of equal states, that of the findings
      b.erase("order");
      EXPECT_EQ(a, b) << seed;
    }
  }
}

TEST(PlanMatch, AFindingElsewhereChangesNoGroup) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    Detection detection = random_floor(seed);
    for (const std::string& plan : {row, count_only}) {
      const nlohmann::ordered_json before = json_of(matched(plan, detection)).at("groups");
      Detection more = detection;
      add_finding(box_at(60, 100), part_mm, more);
      EXPECT_EQ(json_of(matched(plan, more)).at("groups"), before) << seed;
    }
  }
}

TEST(PlanMatch, EachFindingIsInExactlyOneState) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const Detection detection = random_floor(seed);
    const PlanMatch match = matched(
        row +
            "  - { name: other, count: 1, height_mm: [8, 10], areas: [[[120, 0], [190, 0], [190, 110]]] }\n",
        detection);
    std::multiset<int> ids;
    for (const PlannedGroup& group : match.groups) ids.insert(group.findings.begin(), group.findings.end());
    std::set<int> loose;
    for (const LoosePiece& piece : match.unplanned) loose.insert(piece.finding);
    for (const LoosePiece& piece : match.surplus) loose.insert(piece.finding);
    ids.insert(loose.begin(), loose.end());
    EXPECT_EQ(ids.size(), detection.findings.findings.size()) << seed;
    EXPECT_EQ(std::set<int>(ids.begin(), ids.end()).size(), ids.size()) << seed;
    EXPECT_EQ(match.findings.size(), ids.size()) << seed;
  }
}

TEST(PlanMatch, FoundAndAbsentPartsAddUp) {
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    for (const std::string& plan : {row, count_only}) {
      const PlannedGroup group = matched(plan, random_floor(seed)).groups.front();
      EXPECT_EQ(group.found + static_cast<int>(group.missing.size() + group.not_inspected.size()),
                group.planned);
    }
  }
}

TEST(PlanMatch, AddsToDetectionsAndTakesNothingAway) {
  Detection detection = random_floor(3);
  const nlohmann::ordered_json before = json_of(detection.findings);
  nlohmann::ordered_json after = before;
  add_plan(matched(row, detection), after);
  EXPECT_TRUE(after.contains("plan"));
  after.erase("plan");
  for (nlohmann::ordered_json& finding : after.at("detections")) {
    EXPECT_TRUE(finding.contains("planned"));
    EXPECT_EQ(finding.contains("planned_item"), finding.at("planned") != "unplanned");
    finding.erase("planned");
    finding.erase("planned_item");
  }
  EXPECT_EQ(after, before);
}

}  // namespace
}  // namespace rva
