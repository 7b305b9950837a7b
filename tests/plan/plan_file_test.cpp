#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "core/error.hpp"
#include "plan/plan.hpp"

namespace rva {
namespace {

using testing::HasSubstr;

const std::string head = "format: rva-plan\nversion: 1\nparts:\n";

Plan parsed(const std::string& text) { return parse_plan(text, "plan.yaml"); }

std::string fault_of(const std::string& text) {
  try {
    (void)parsed(text);
  } catch (const Error& error) {
    EXPECT_FALSE(error.remedy().empty());
    return error.what();
  }
  return "accepted";
}

std::string part(const std::string& name, const std::string& rest) {
  return "  - { name: " + name + ", height_mm: [8, 10], " + rest + " }\n";
}

const std::string square = "areas: [[[0, 0], [20, 0], [20, 20], [0, 20]]]";

TEST(PlanFile, ReadsAreasInPixels) {
  const Plan plan =
      parsed(head + part("nuts in bay 2", "kind: removed, count: 3, size_mm: [9, 12], " + square));
  ASSERT_EQ(plan.items.size(), 1U);
  const PlannedItem& item = plan.items.front();
  EXPECT_EQ(plan.coordinates, PlanCoordinates::pixels);
  EXPECT_EQ(item.name, "nuts in bay 2");
  EXPECT_EQ(item.kind, ChangeKind::removed);
  EXPECT_EQ(item.count, 3);
  EXPECT_EQ(item.height_mm, (RangeMm{8, 10}));
  EXPECT_EQ(item.size_mm, (RangeMm{9, 12}));
  ASSERT_EQ(item.areas.size(), 1U);
  EXPECT_EQ(item.areas.front().at(2), (PlanPoint{{20, 20}, 0.0}));
}

TEST(PlanFile, ReadsPlacesInMetresAlongTheirRay) {
  const Plan plan = parsed("format: rva-plan\nversion: 1\ncoordinates: metres\nparts:\n" +
                           part("collars", "places: [[0.1, -0.2, 0.5], [0, 0, 1]], tolerance_mm: 4"));
  const PlannedItem& item = plan.items.front();
  EXPECT_EQ(item.count, 2);
  EXPECT_EQ(item.kind, ChangeKind::added);
  EXPECT_DOUBLE_EQ(item.tolerance_mm, 4.0);
  EXPECT_TRUE(item.places.front().at.isApprox(Eigen::Vector2d(0.2, -0.4)));
  EXPECT_DOUBLE_EQ(item.places.front().depth_m, 0.5);
}

TEST(PlanFile, NamesFileLineAndFieldOfWhatIsWrong) {
  const auto refused = [](const std::string& rest, const std::string& problem) {
    const std::string fault = fault_of(head + part("a", "count: 1, " + square) + part("b", rest));
    EXPECT_THAT(fault, HasSubstr("plan.yaml:5: field parts[1]")) << rest;
    EXPECT_THAT(fault, HasSubstr(problem)) << rest;
  };
  const std::string elsewhere = "areas: [[[50, 0], [70, 0], [70, 20]]]";
  refused("kind: collar, count: 1, " + elsewhere, "unknown kind \"collar\"");
  refused("count: 0, " + elsewhere, "\"0\" is out of range");
  refused("count: 1, areas: [[[50, 0], [70, 0]]]", "fewer than three corners");
  refused("count: 1, areas: [[[50, 0], [70, 20], [70, 0], [50, 20]]]", "crosses or touches itself");
  refused("count: 1, size_mm: [12, 9], " + elsewhere, "the first limit is above the second");
  refused("count: 1", "neither areas nor places");
  refused(elsewhere, "neither count nor places");
  refused("count: 3, places: [[50, 0], [60, 0]]", "3 parts, but 2 places");
  refused("count: 1, places: [[50, 0, 1]]", "3 entries, not 2");
}

TEST(PlanFile, RefusesAPlanThatOverlapsItself) {
  const std::string first = part("a", "count: 1, " + square);
  const std::string over = "count: 1, areas: [[[10, 10], [30, 10], [30, 30], [10, 30]]]";
  EXPECT_THAT(fault_of(head + first + part("b", over)),
              HasSubstr("plan.yaml:5: field parts[1].areas: overlaps an area of a"));
  EXPECT_EQ(fault_of(head + first + part("b", "kind: removed, " + over)), "accepted");
  EXPECT_THAT(fault_of(head + first + part("a", "count: 1, areas: [[[50, 0], [70, 0], [70, 20]]]")),
              HasSubstr("another entry has this name"));
  EXPECT_THAT(fault_of(head + part("a", "places: [[5, 5], [9, 9], [5, 5.5]]")),
              HasSubstr("place 3 is too near to place 1 of a"));
}

TEST(PlanFile, AcceptsAreasWithACommonBorder) {
  EXPECT_EQ(fault_of(head + part("a", "count: 1, " + square) +
                     part("b", "count: 1, areas: [[[20, 0], [40, 0], [40, 20], [20, 20]]]")),
            "accepted");
}

TEST(PlanFile, WhatIsWrittenIsReadBack) {
  const Plan plan = parsed(head + part("nuts \"A\"", "kind: removed, count: 3, size_mm: [9, 12], " + square) +
                           part("collars", "places: [[50.5, 7], [60, 7.25]], tolerance_mm: 4") +
                           "  - { name: sealant, kind: appearance, count: 1, "
                           "areas: [[[90, 0], [99, 0], [99, 9]]] }\n");
  EXPECT_EQ(parsed(json_of(plan).dump()), plan);

  const Plan metres = parsed("format: rva-plan\nversion: 1\ncoordinates: metres\nparts:\n" +
                             part("collars", "places: [[0.1, -0.2, 0.5], [0.15, -0.2, 0.7]]"));
  const Plan again = parsed(json_of(metres).dump());
  ASSERT_EQ(again.items.size(), 1U);
  EXPECT_EQ(again.coordinates, PlanCoordinates::metres);
  for (std::size_t i = 0; i < 2; ++i) {
    const PlanPoint& before = metres.items[0].places[i];
    const PlanPoint& after = again.items[0].places[i];
    EXPECT_TRUE(after.at.isApprox(before.at, 1e-12));
    EXPECT_EQ(after.depth_m, before.depth_m);
  }
}

TEST(PlanFile, RefusesOtherFiles) {
  EXPECT_THAT(fault_of("format: rva-scene\nversion: 1\nparts: []\n"), HasSubstr("not a plan"));
  EXPECT_THAT(fault_of("format: rva-plan\nversion: 2\nparts: []\n"), HasSubstr("plan.yaml:2"));
  EXPECT_THAT(fault_of("format: rva-plan\nversion: 1\nparts: []\n"), HasSubstr("empty"));
  EXPECT_THAT(fault_of("format: rva-plan\nversion: 1\npart: []\n"), HasSubstr("unknown key \"part\""));
  EXPECT_THROW((void)read_plan("/nowhere/plan.yaml"), Error);
}

}  // namespace
}  // namespace rva
