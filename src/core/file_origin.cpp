#include "core/file_origin.hpp"

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cstdint>
#include <cstdlib>
#include <nlohmann/json.hpp>
#include <string_view>
#include <system_error>

#include "core/date_time.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"

namespace rva {

std::string time_of_making() {
  const char* const stated = std::getenv("SOURCE_DATE_EPOCH");
  if (stated == nullptr) return iso_8601_now();
  const std::string_view text(stated);
  constexpr std::int64_t most_s = 253'402'300'799;  // the end of the year 9999
  std::int64_t since_1970_s = -1;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), since_1970_s);
  if (failure != std::errc{} || end != text.data() + text.size() || since_1970_s < 0 || since_1970_s > most_s)
    throw Error("SOURCE_DATE_EPOCH", printable(text) + " is no time",
                "set it to seconds since 1970, or unset it");
  // Clocks count nanoseconds, which end in 2262.
  constexpr std::int64_t last_s = 9'223'372'036;
  return iso_8601(
      std::chrono::system_clock::time_point(std::chrono::seconds(std::min(since_1970_s, last_s))));
}

nlohmann::ordered_json provenance_json(const std::string& created_at) {
  return {{"program", "rva"}, {"version", RVA_VERSION}, {"created_at", created_at}};
}

}  // namespace rva
