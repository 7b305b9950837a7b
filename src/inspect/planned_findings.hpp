// The findings of a view compared with its plan.
#pragma once

#include <vector>

#include "capture/capture.hpp"
#include "detect/detect.hpp"
#include "inspect/inspection.hpp"
#include "plan/plan_match.hpp"

namespace rva {

/// Sets the state of each finding of a view, and adds a finding for each planned part that is missing: at its
/// place, or in the item's first area where the plan has no places.
/// @param initial  the first initial capture, in whose picture the plan is
/// @param final    the description of the first final capture, in whose view the findings are
/// @param findings of this view, all of `detection`, in any order
void add_planned(std::vector<ReviewedFinding>& findings, const PlanMatch& match, const Plan& plan,
                 const Detection& detection, const Capture& initial, const CaptureInfo& final);

/// What was found of each item of a plan.
[[nodiscard]] std::vector<PlannedWork> planned_work(const PlanMatch& match);

}  // namespace rva
