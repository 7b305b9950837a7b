// The log of the program, on stderr.
#pragma once

#include <string>

#include "core/event.hpp"

namespace rva::cli {

/// Prints "rva: " and the event. Where stderr leads to systemd's journal, the line begins with the level.
/// May be called from any thread.
void log_event(const Event& event);

/// Prints "rva: " and a line for people, which is an error in the journal.
void complain(const std::string& line);

}  // namespace rva::cli
