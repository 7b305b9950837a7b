// What an inspection showed, as numbers.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

#include "inspect/verdict_counts.hpp"

namespace rva {

/// The findings of an inspection over all complete comparisons, also of those that later ones replaced.
/// Findings of several views of the same object are one object, with the latest decision on the most
/// suspicious one.
struct InspectionTally {
  std::int64_t id = 0;
  std::string zone;
  std::string created_at;  ///< ISO 8601
  std::string closed_at;   ///< ISO 8601; empty while it is open
  std::size_t comparisons = 0;
  VerdictCounts found;   ///< objects that the program found, counted anew in each comparison
  VerdictCounts marked;  ///< objects that people marked
  /// Numbers of objects that are debris, found or marked, by what people named them; those that nobody named
  /// are at the empty name.
  std::map<std::string, std::size_t> debris_by_name;
};

}  // namespace rva
