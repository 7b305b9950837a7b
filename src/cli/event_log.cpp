#include "cli/event_log.hpp"

#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>

namespace rva::cli {
namespace {

// systemd.exec(5), JOURNAL_STREAM: the device and the inode of the stream that leads to the journal.
bool stderr_is_journal() {
  const char* const stream = std::getenv("JOURNAL_STREAM");
  struct stat own {};
  return stream != nullptr && fstat(STDERR_FILENO, &own) == 0 &&
         fmt::format("{}:{}", own.st_dev, own.st_ino) == stream;
}

void print_line(EventLevel level, const std::string& line) {
  static const bool journal = stderr_is_journal();
  fmt::print(stderr, "{}rva: {}\n", journal ? journal_prefix(level) : "", line);
}

}  // namespace

void log_event(const Event& event) { print_line(event.level, event_text(event)); }

void complain(const std::string& line) { print_line(EventLevel::error, line); }

}  // namespace rva::cli
