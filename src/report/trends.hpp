// What the inspections of each zone and month showed, as it was reviewed.
#pragma once

#include <compare>
#include <cstddef>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "inspect/inspection_tally.hpp"

namespace rva {

/// A zone as it was entered, and the month in which inspections were begun: "2026-01", UTC.
struct ZoneMonth {
  std::string zone;
  std::string month;
  std::strong_ordering operator<=>(const ZoneMonth&) const = default;
};

/// Sums over inspections.
struct Trend {
  std::size_t inspections = 0;
  std::size_t closed = 0;       ///< number of them that were closed
  std::size_t comparisons = 0;  ///< number of complete ones, also of those that later ones replaced
  VerdictCounts found;          ///< objects that the program found, counted anew in each comparison
  VerdictCounts marked;         ///< objects that people marked
  std::map<std::string, std::size_t> debris_by_name{};  ///< InspectionTally::debris_by_name
  std::vector<double> hours{};  ///< from the beginning to the closing of each that was closed

  /// The median of `hours`; empty if there are none.
  [[nodiscard]] std::optional<double> median_hours() const;
  /// Objects that were found and decided on.
  [[nodiscard]] std::size_t decided() const { return found.all() - found.undecided; }
  Trend& operator+=(const Trend& more);
};

/// Trends by zone and month, in their order.
using Trends = std::map<ZoneMonth, Trend>;

[[nodiscard]] Trends trends_of(const std::vector<InspectionTally>& tallies);

/// The sum of all.
[[nodiscard]] Trend sum_of(const Trends& trends);

/// Sums of all zones by month, and of all months by zone.
[[nodiscard]] std::map<std::string, Trend> by_month(const Trends& trends);
[[nodiscard]] std::map<std::string, Trend> by_zone(const Trends& trends);

/// Trends as CSV (csv_row()), with a head.
[[nodiscard]] std::string csv_of(const Trends& trends);

}  // namespace rva
