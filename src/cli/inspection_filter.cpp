#include "cli/inspection_filter.hpp"

#include <chrono>

#include "cli/option_flags.hpp"
#include "core/date_time.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"

namespace rva::cli {
namespace {

// A day or a time, as the records write times. A day that no month has is read as one of the next month.
std::string time_of(const std::string& given, const std::string& flag) {
  if (given.empty()) return given;
  constexpr std::size_t day_length = 10;
  const auto ns = ns_since_1970(given.size() == day_length ? given + "T00:00:00Z" : given);
  const std::string time =
      !ns ? "" : iso_8601(std::chrono::system_clock::time_point(std::chrono::nanoseconds(*ns)));
  if (time.empty() || !given.starts_with(time.substr(0, day_length)))
    throw UsageError(flag, printable(given) + " is no date", "give one such as 2026-01-31, in UTC");
  return time;
}

}  // namespace

void add_inspection_filter(CLI::App& command, InspectionFilterFlags& flags) {
  command
      .add_option("--text", flags.text,
                  "words that each occur in the aircraft, zone, work order, person or number")
      ->type_name("WORDS");
  command.add_option("--stage", flags.stage, "the next step: baseline, work, review, or done")
      ->check(name_among<Stage>())
      ->type_name("STAGE");
  command.add_option("--from", flags.from, "begun on this day (UTC) or later")->type_name("DATE");
  command.add_option("--until", flags.until, "begun before this day (UTC)")->type_name("DATE");
}

InspectionFilter filter_of(const InspectionFilterFlags& flags) {
  return {.text = flags.text,
          .stage = value_of<Stage>(flags.stage),
          .from = time_of(flags.from, "--from"),
          .until = time_of(flags.until, "--until")};
}

}  // namespace rva::cli
