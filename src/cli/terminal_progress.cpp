#include "cli/terminal_progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdio>

namespace rva::cli {

Progress terminal_progress() {
  if (::isatty(STDERR_FILENO) == 0) return {};
  return [](std::string_view step, std::size_t done, std::size_t total) {
    constexpr const char* wipe_line = "\r\033[K";
    if (done == total) {
      fmt::print(stderr, "{}", wipe_line);
    } else {
      fmt::print(stderr, "{}{} {}/{}", wipe_line, step, done, total);
    }
    std::fflush(stderr);
  };
}

}  // namespace rva::cli
