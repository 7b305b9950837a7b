#include "core/date_time.hpp"

#include <fmt/format.h>

#include <array>
#include <ctime>
#include <iomanip>
#include <regex>
#include <sstream>
#include <string_view>

namespace rva {

std::string iso_8601(std::chrono::system_clock::time_point moment) {
  const auto since_1970 = std::chrono::floor<std::chrono::milliseconds>(moment.time_since_epoch());
  const auto whole = std::chrono::floor<std::chrono::seconds>(since_1970);
  const auto seconds = static_cast<std::time_t>(whole.count());
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  std::array<char, 32> text{};
  const std::size_t length = std::strftime(text.data(), text.size(), "%Y-%m-%dT%H:%M:%S", &parts);
  return fmt::format("{}.{:03}Z", std::string_view(text.data(), length), (since_1970 - whole).count());
}

std::optional<std::uint64_t> ns_since_1970(const std::string& text) {
  static const std::regex form(R"((\d{4}-\d\d-\d\dT\d\d:\d\d:\d\d)(?:\.(\d{1,9}))?Z)");
  std::smatch match;
  if (!std::regex_match(text, match, form)) return std::nullopt;
  std::tm parts{};
  std::istringstream whole(match[1].str());
  if (!(whole >> std::get_time(&parts, "%Y-%m-%dT%H:%M:%S"))) return std::nullopt;
  const std::time_t since_1970_s = timegm(&parts);
  if (since_1970_s < 0) return std::nullopt;
  std::string nanoseconds = match[2];
  nanoseconds.resize(9, '0');
  return static_cast<std::uint64_t>(since_1970_s) * 1'000'000'000U + std::stoul(nanoseconds);
}

}  // namespace rva
