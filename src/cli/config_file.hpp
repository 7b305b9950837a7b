// Options of a command from a file.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace rva::cli {

/// Gives the command what the file says, one `option = value` a line, `#` before comments, names without
/// dashes; what the command line says already stays. Call it from the command's callback; required options
/// are the caller's to check.
/// @throws Error when the file cannot be read, or names an option that the command has not; UsageError for a
///         value that the option refuses
void apply_config_file(CLI::App& command, const std::string& path);

}  // namespace rva::cli
