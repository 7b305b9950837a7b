// The report on an inspection before it is rendered: what HTML and PDF both contain.
#pragma once

#include <cstdint>
#include <string>

#include "inspect/inspection.hpp"
#include "inspect/inspection_folder.hpp"
#include "report/report_content.hpp"

namespace rva {

/// A report without its foot.
struct ReportDocument {
  std::int64_t inspection = 0;   ///< its number
  std::string title{};           ///< aircraft, zone and work order
  Content content{};             ///< the verdict first
  std::string last_action_at{};  ///< ISO 8601: the newest time that the records state
};

/// The verdict, what was inspected and down to which size, every finding of every comparison with pictures
/// and decisions, the actions of each person, settings and checksums. The state of the records determines it.
/// Where a file that the records name cannot be read, the reason is in its place (or_reason()).
/// @param folder of the inspection
/// @throws Interrupted
[[nodiscard]] ReportDocument report_on(const InspectionHistory& history, const InspectionFolder& folder);

/// The program with its version.
[[nodiscard]] std::string program_text();

/// That a report alone proves nothing. @param made when, or from what, it was made: ", 2026-01-01 00:00 UTC"
[[nodiscard]] Content report_foot(const std::string& made);

}  // namespace rva
