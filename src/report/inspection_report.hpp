// The report on an inspection: one HTML file with its pictures, for a person with little time, a printer and
// an archive.
#pragma once

#include <string>

#include "inspect/inspection.hpp"
#include "inspect/inspection_folder.hpp"

namespace rva {

/// A document that needs no other file and runs no script: the verdict first, then what was inspected and
/// down to which size, every finding of every comparison with pictures and decisions, the actions of each
/// person, settings and checksums. It fits A4 and Letter. The state of the records determines it, with the
/// time that it states. Where a file that the records name cannot be read, the reason is in its place
/// (or_reason()).
/// @param folder  of the inspection
/// @param made_at ISO 8601 in UTC (time_of_making())
/// @throws Interrupted
[[nodiscard]] std::string inspection_report(const InspectionHistory& history, const InspectionFolder& folder,
                                            const std::string& made_at);

}  // namespace rva
