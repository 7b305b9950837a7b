// Inspections in the data folder of `rva serve`, for commands that read them.
#pragma once

#include <CLI/CLI.hpp>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "inspect/inspection.hpp"
#include "inspect/inspection_tally.hpp"

namespace rva::cli {

/// Adds the required flag `--data` for the folder of inspections.
void add_data_folder(CLI::App& command, std::string& data);

/// Adds the required flags `--data` and `--inspection` for one inspection.
void add_recorded_inspection(CLI::App& command, std::string& data, std::int64_t& inspection);

/// The numbers of all inspections of a data folder, ascending. @throws Error when the folder has no records
[[nodiscard]] std::vector<std::int64_t> recorded_inspections(const std::string& data);

/// The inspections of a data folder that a filter selects, newest first. @throws Error when the folder has no
/// records
[[nodiscard]] std::vector<InspectionSummary> recorded_summaries(const std::string& data,
                                                                const InspectionFilter& filter);

/// What inspections of a data folder showed, as numbers; as recorded_summaries().
[[nodiscard]] std::vector<InspectionTally> recorded_tallies(const std::string& data,
                                                            const InspectionFilter& filter);

/// All that the records of a data folder contain of an inspection.
/// @throws Error when the folder has no records, or these have no such inspection
[[nodiscard]] InspectionHistory recorded_inspection(const std::string& data, std::int64_t number);

/// Calls `visit` with all that the records contain of each inspection, by ascending numbers.
/// @throws Error when the folder has no records; what `visit` throws
void visit_recorded(const std::string& data, const std::function<void(const InspectionHistory&)>& visit);

}  // namespace rva::cli
