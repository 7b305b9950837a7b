// Versions of firmware.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace rva {

/// The numbers of a version such as "5.13.0.50"; empty for any other text.
[[nodiscard]] inline std::optional<std::vector<int>> version_numbers(std::string_view text) {
  std::vector<int> numbers{0};
  bool digit_before = false;
  for (const char c : text) {
    const bool digit = c >= '0' && c <= '9';
    constexpr int most = 1'000'000;
    if ((!digit && c != '.') || (!digit && !digit_before) || numbers.back() > most) return std::nullopt;
    if (digit)
      numbers.back() = 10 * numbers.back() + (c - '0');
    else
      numbers.push_back(0);
    digit_before = digit;
  }
  return digit_before ? std::optional(numbers) : std::nullopt;
}

}  // namespace rva
