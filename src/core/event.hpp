// What happens while the program runs, as a line of a log that people and programs read.
#pragma once

#include <string>
#include <utility>
#include <vector>

namespace rva {

/// How much an event matters; the values are those of syslog.
enum class EventLevel {
  error = 3,    ///< the program ends
  warning = 4,  ///< something needs attention
  notice = 5,   ///< something changed that matters
  info = 6,     ///< ordinary work
};

/// Something that happened.
struct Event {
  EventLevel level = EventLevel::info;  ///< how much it matters
  std::string name;     ///< for programs, such as "camera-failed". Names are added, never changed
  std::string message;  ///< one line for people
  std::vector<std::pair<std::string, std::string>> fields{};  ///< names of small letters, with their values
};

/// "MESSAGE event=NAME key=value ...", one line. A value with other characters than letters, digits and
/// `.:/_+-` is in quotation marks, as in JSON.
[[nodiscard]] std::string event_text(const Event& event);

/// The prefix by which journald reads the level of a line, such as "<4>" (sd-daemon(3)).
[[nodiscard]] std::string journal_prefix(EventLevel level);

}  // namespace rva
