// Signed packages of inspections (docs/record.md): writing them, and those in a data folder.
#pragma once

#include <cstdint>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "audit/package_writer.hpp"
#include "core/progress.hpp"
#include "inspect/inspection.hpp"

namespace rva {

/// Exports an inspection, signs it, appends its record to the site's log and writes the package, whole or not
/// at all. If the program is stopped after the record is in the log, the log has a record without a package.
/// @param data     the folder of all inspections
/// @param out      the folder to appear; what was signed is never replaced
/// @param progress counts the files that are copied
/// @throws Error when `out` exists, the log is damaged or of another key, a capture or a result that the
///         records name is missing, or the disk refuses; Interrupted
void write_signed_package(const InspectionHistory& history, const std::filesystem::path& data,
                          const std::filesystem::path& out, const PackageSigning& signing,
                          const Progress& progress);

/// A signed package in a data folder, as its statement describes it; not verified.
struct SignedPackage {
  std::string folder;                ///< relative to the data folder, with slashes
  std::string signed_at;             ///< ISO 8601 in UTC; empty if the package cannot be read
  std::vector<std::string> signers;  ///< verifier_key() of each; empty if the package cannot be read
};

/// Where the next signed package of an inspection goes: DATA/signed/000012-1, then DATA/signed/000012-2.
[[nodiscard]] std::filesystem::path next_signed_package(const std::filesystem::path& data, std::int64_t id);

/// The signed packages of an inspection in DATA/signed, in their order.
[[nodiscard]] std::vector<SignedPackage> signed_packages(const std::filesystem::path& data, std::int64_t id);

/// The inspections that have signed packages in DATA/signed, by the names of the packages alone.
[[nodiscard]] std::set<std::int64_t> signed_inspections(const std::filesystem::path& data);

/// Removes packages in DATA/signed that were incomplete when the program was stopped. Call this before
/// anything else uses the folder.
/// @return one sentence for the user for each
std::vector<std::string> remove_incomplete_packages(const std::filesystem::path& data);

}  // namespace rva
