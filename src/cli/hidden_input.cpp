#include "cli/hidden_input.hpp"

#include <fmt/format.h>
#include <poll.h>
#include <termios.h>
#include <unistd.h>

#include <cstdio>
#include <iostream>

#include "core/error.hpp"
#include "core/interrupt.hpp"

namespace rva::cli {
namespace {

/// Turns off the echo of the terminal at stdin, and restores its settings on destruction.
class WithoutEcho {
 public:
  WithoutEcho() {
    if (::tcgetattr(STDIN_FILENO, &before_) != 0)
      throw Error("input", "is not a terminal", "type the line on a terminal, or pipe it in");
    termios hidden = before_;
    hidden.c_lflag &= ~static_cast<tcflag_t>(ECHO);
    ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &hidden);
  }
  ~WithoutEcho() {
    ::tcsetattr(STDIN_FILENO, TCSAFLUSH, &before_);
    std::fputs("\n", stderr);  // the end of the line was not displayed, either
  }
  WithoutEcho(const WithoutEcho&) = delete;
  WithoutEcho& operator=(const WithoutEcho&) = delete;

 private:
  termios before_{};
};

// Returns as soon as there is something to read, and often enough to notice an interrupt that arrived just
// before the wait.
bool has_input() {
  constexpr int wait_ms = 100;
  pollfd input{STDIN_FILENO, POLLIN, 0};
  return ::poll(&input, 1, wait_ms) > 0;
}

}  // namespace

std::string read_hidden_line(const std::string& prompt) {
  const WithoutEcho without_echo;
  fmt::print(stderr, "{}", prompt);
  std::string line;
  for (;;) {
    throw_if_interrupted();
    if (!has_input()) continue;
    char typed = 0;
    if (::read(STDIN_FILENO, &typed, 1) != 1 || typed == '\n') return line;
    line += typed;
  }
}

std::string read_password(const std::string& prompt) {
  if (::isatty(STDIN_FILENO) == 1) return read_hidden_line(prompt);
  std::string line;
  std::getline(std::cin, line);
  return line;
}

}  // namespace rva::cli
