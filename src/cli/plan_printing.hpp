// Findings compared with a plan, for a person.
#pragma once

#include <vector>

#include "detect/findings/findings.hpp"
#include "plan/plan_match.hpp"

namespace rva::cli {

/// Prints what was not planned, then one line for each group, then what is missing, what was not inspected
/// and what is surplus.
void print_plan(const PlanMatch& match, const std::vector<Finding>& findings);

}  // namespace rva::cli
