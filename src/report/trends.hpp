// What the inspections of each zone and month showed, as it was reviewed.
#pragma once

#include <compare>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "inspect/inspection.hpp"
#include "report/object_groups.hpp"

namespace rva {

/// A zone as it was entered, and the month in which inspections were begun: "2026-01", UTC.
struct ZoneMonth {
  std::string zone;
  std::string month;
  std::strong_ordering operator<=>(const ZoneMonth&) const = default;
};

/// Sums over the inspections of one zone and month.
struct Trend {
  std::size_t inspections = 0;
  std::size_t closed = 0;       ///< number of them that were closed
  std::size_t comparisons = 0;  ///< number of complete ones, also of those that later ones replaced
  VerdictCounts found;          ///< objects that the program found, counted anew in each comparison
  VerdictCounts marked;         ///< objects that people marked
  std::vector<double> hours{};  ///< from the beginning to the closing of each that was closed

  /// The median of `hours`; empty if there are none.
  [[nodiscard]] std::optional<double> median_hours() const;
};

/// Trends by zone and month, in their order.
using Trends = std::map<ZoneMonth, Trend>;

/// Adds an inspection.
void add_to(Trends& trends, const InspectionHistory& history);

/// The sum of all.
[[nodiscard]] Trend sum_of(const Trends& trends);

}  // namespace rva
