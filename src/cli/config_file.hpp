// Reads options of a command from a file.
#pragma once

#include <CLI/CLI.hpp>
#include <string>

namespace rva::cli {

/// Sets the options that the file states, one `option = value` a line, `#` before comments, names without
/// dashes. Options that were given on the command line take precedence. Call it from the command's callback;
/// the caller has to check required options.
/// @throws Error when the file cannot be read; UsageError for a line that is no option = value, an option
/// that
///         the command does not have, and a value that the option refuses
void apply_config_file(CLI::App& command, const std::string& path);

}  // namespace rva::cli
