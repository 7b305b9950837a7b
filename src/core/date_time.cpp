#include "core/date_time.hpp"

#include <fmt/format.h>

#include <array>
#include <ctime>
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

}  // namespace rva
