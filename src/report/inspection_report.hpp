// The report on an inspection: one HTML file with its pictures, for a person with little time, a printer and
// an archive.
#pragma once

#include <string>

#include "inspect/inspection.hpp"
#include "inspect/inspection_folder.hpp"
#include "report/report_document.hpp"

namespace rva {

/// A document that needs no other file and runs no script, and that fits A4 and Letter. The report determines
/// it, with the time that it states.
/// @param made_at ISO 8601 in UTC (time_of_making())
[[nodiscard]] std::string html_report(const ReportDocument& report, const std::string& made_at);

/// html_report() of report_on(). @throws Interrupted
[[nodiscard]] std::string inspection_report(const InspectionHistory& history, const InspectionFolder& folder,
                                            const std::string& made_at);

}  // namespace rva
