// Where the console's files are.
#pragma once

#include <string>

namespace rva::cli {

/// Looks relative to the running program: for `console/` of a build, and for `../share/rva/console/` of an
/// installation.
/// @throws Error when there is neither
[[nodiscard]] std::string console_folder();

}  // namespace rva::cli
