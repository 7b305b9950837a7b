// Results on stdout.
#pragma once

#include <fmt/format.h>

#include <cstdio>
#include <string>
#include <utility>

namespace rva::cli {

/// Writes to stdout as fmt::print does, but leaves a failure for require_printed() to report: a full disk is
/// an error for the user, not an exception from deep inside.
template <typename... Arguments>
void print(fmt::format_string<Arguments...> format, Arguments&&... arguments) {
  const std::string text = fmt::format(format, std::forward<Arguments>(arguments)...);
  static_cast<void>(std::fwrite(text.data(), 1, text.size(), stdout));
}

/// Flushes the standard output. @throws Error when a result could not be printed
void require_printed();

}  // namespace rva::cli
