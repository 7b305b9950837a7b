// The sections of a report, in the order in which they are read. Where a file cannot be read, the reason is
// in its place (or_reason()).
#pragma once

#include <string>

#include "inspect/inspection.hpp"
#include "inspect/inspection_folder.hpp"
#include "report/report_content.hpp"

namespace rva {

/// What was inspected, down to which size, and what was not and why, with a picture of each view.
/// Nothing before the first comparison.
[[nodiscard]] Content coverage_section(const InspectionHistory& history, const InspectionFolder& folder);

/// The findings of every comparison, newest first, and what people marked or kept: pictures before and after,
/// decision, by whom.
[[nodiscard]] Content findings_section(const InspectionHistory& history, const InspectionFolder& folder);

/// The check-out list, with what became of each item. Nothing where there is no list.
[[nodiscard]] Content items_section(const Inspection& inspection);

/// The actions of each person with their times. Decisions on several findings at once are one row; those that
/// were superseded are there, too.
[[nodiscard]] Content events_section(const InspectionHistory& history);

/// The newest time that an action has in the records, ISO 8601.
[[nodiscard]] std::string last_action_at(const InspectionHistory& history);

/// With what it was inspected: camera, captures, method and its options.
[[nodiscard]] Content settings_section(const InspectionHistory& history, const InspectionFolder& folder);

/// For each folder of captures and results a checksum that anyone can compute again.
/// @throws Interrupted
[[nodiscard]] Content checksums_section(const InspectionHistory& history, const InspectionFolder& folder);

}  // namespace rva
