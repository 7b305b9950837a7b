#include "server/inspection_filter.hpp"

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <string>

#include "core/path_text.hpp"
#include "server/api.hpp"

namespace rva {
namespace {

constexpr std::size_t most_listed = 10'000;

template <typename Number>
Number number_in(const QueryValues& query, const std::string& key, Number most) {
  const auto found = query.find(key);
  if (found == query.end()) return 0;
  Number number = 0;
  const std::string& text = found->second;
  const auto [end, failure] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (failure != std::errc{} || end != text.data() + text.size() || number < 1 || number > most)
    throw ApiError(400, "bad-request", key, printable(text) + " is not a number from 1", "see docs/api.md");
  return number;
}

std::string text_in(const QueryValues& query, const std::string& key) {
  const auto found = query.find(key);
  return found == query.end() ? "" : found->second;
}

}  // namespace

InspectionFilter filter_in(const QueryValues& query) {
  for (const auto& [key, value] : query) {
    constexpr std::array known{"text", "stage", "from", "until", "before", "most"};
    if (std::ranges::find(known, key) == known.end())
      throw ApiError(400, "bad-request", "list", "cannot be filtered by " + printable(key),
                     "see docs/api.md");
  }
  InspectionFilter filter{.text = text_in(query, "text"),
                          .stage = value_of<Stage>(text_in(query, "stage")),
                          .from = text_in(query, "from"),
                          .until = text_in(query, "until"),
                          .before = number_in(query, "before", std::numeric_limits<std::int64_t>::max()),
                          .most = number_in(query, "most", most_listed)};
  if (query.contains("stage") && !filter.stage)
    throw ApiError(400, "bad-request", "stage", "is none of baseline, work, review, done", "see docs/api.md");
  return filter;
}

}  // namespace rva
