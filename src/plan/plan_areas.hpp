// Checks of the areas and places of a plan.
#pragma once

#include <string>
#include <vector>

#include "plan/plan.hpp"

namespace rva {

/// What is wrong with a polygon, such as a border that crosses itself; empty if nothing is.
[[nodiscard]] std::string fault_of(const std::vector<PlanPoint>& polygon);

/// Whether any area of one item shares more than a border with an area of the other.
[[nodiscard]] bool overlap(const PlannedItem& a, const PlannedItem& b);

/// How far apart two places are, in pixels or in millimetres as the coordinates are.
[[nodiscard]] double distance_between(const PlanPoint& a, const PlanPoint& b, PlanCoordinates coordinates);

}  // namespace rva
