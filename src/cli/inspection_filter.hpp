// Flags that select inspections.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

#include "inspect/inspection.hpp"

namespace rva::cli {

/// The values of the flags; empty ones have no effect.
struct InspectionFilterFlags {
  std::string text;   ///< words
  std::string stage;  ///< name of a Stage
  std::string from;   ///< a day or a time
  std::string until;  ///< a day or a time
};

/// Adds `--text`, `--stage`, `--from` and `--until`.
void add_inspection_filter(CLI::App& command, InspectionFilterFlags& flags);

/// @throws UsageError for a date that is none
[[nodiscard]] InspectionFilter filter_of(const InspectionFilterFlags& flags);

}  // namespace rva::cli
