// An inspection as a folder of files in open formats, which other programs read and `rva detect` compares.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/output_folder.hpp"
#include "core/progress.hpp"
#include "inspect/inspection.hpp"

namespace rva {

/// The files of an exported inspection, as patterns for an OutputFolder; the first is in each.
[[nodiscard]] std::vector<std::string> exported_files();

/// Writes into a folder what export_inspection() does, for a caller that makes it appear as a whole.
/// @param folder exists; what is written is incomplete if this throws
void write_exported_inspection(const InspectionHistory& history, const std::filesystem::path& data,
                               const std::filesystem::path& folder, const Progress& progress);

/// Writes a folder with everything that belongs to an inspection, whole or not at all (OutputFolder):
///   - `inspection.json`: the records in the JSON of the API, with the paths of all files and the provenance
///     (docs/formats.md);
///   - the captures of every complete round, the results of every comparison, the baseline check and the
///     pictures in which findings were marked or that were kept, under the names that they have in the
///     inspection's folder;
///   - `report.html` and `report.pdf`: all of it for people (inspection_report(), pdf_report());
///   - `regions/000.json` of each view of which something is left out.
/// Paths in the results are relative to this folder.
/// @param data     the folder of all inspections
/// @param out      the folder to appear
/// @param existing what to do with an earlier export of an inspection in its place
/// @param progress counts files
/// @throws Error when a capture or a result that the records name is missing or cannot be copied, or `out`
///         cannot be written; Interrupted
void export_inspection(const InspectionHistory& history, const std::filesystem::path& data,
                       const std::filesystem::path& out, Existing existing, const Progress& progress);

}  // namespace rva
