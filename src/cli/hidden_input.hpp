// Input that is not displayed while it is typed, such as a password.
#pragma once

#include <string>

namespace rva::cli {

/// Prompts on stderr and reads a line from the terminal at stdin, which does not display it. The terminal's
/// settings are restored in all cases.
/// @return the line without its end; what was typed until then if the input ends early
/// @throws Error when stdin is not a terminal; Interrupted
[[nodiscard]] std::string read_hidden_line(const std::string& prompt);

/// Reads a password: on a terminal as read_hidden_line() does, otherwise the next line of stdin, without a
/// prompt. Passwords are not taken from the command line, where others can read them.
[[nodiscard]] std::string read_password(const std::string& prompt);

}  // namespace rva::cli
