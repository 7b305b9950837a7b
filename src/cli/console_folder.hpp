// Where the console's files are.
#pragma once

#include <string>

namespace rva::cli {

/// Beside the program that runs: `console/` as it is built, `../share/rva/console/` as it is installed.
/// @throws Error when it is at neither
[[nodiscard]] std::string console_folder();

}  // namespace rva::cli
