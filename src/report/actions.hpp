// What people did in an inspection, and when.
#pragma once

#include <string>
#include <vector>

#include "inspect/inspection.hpp"
#include "report/report_content.hpp"

namespace rva {

/// An action as the records have it.
struct Action {
  std::string at;      ///< ISO 8601
  std::string person;  ///< empty: the program
  Content what;        ///< one line of text and typed parts
};

/// All actions of an inspection in the order of their times: captures, comparisons, decisions, superseded
/// ones included, marks, snapshots, statements on the check-out list, closing. Decisions that a person made
/// alike on several findings, one after another within a minute, are one action.
[[nodiscard]] std::vector<Action> actions_of(const InspectionHistory& history);

}  // namespace rva
