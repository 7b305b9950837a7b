// Totals of a study of moved cameras.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evaluate/moved_study.hpp"
#include "evaluate/probability_of_detection.hpp"

namespace rva {

/// Counts over all inspections, for one method, setting and number of captures per side.
struct MovedTally {
  std::string method;                 ///< see MovedResult::method
  int captures = 1;                   ///< captures per side
  double setting = 0.0;               ///< see MovedResult::setting
  std::size_t inspections = 0;        ///< number of inspections
  std::size_t false_when_clean = 0;   ///< findings where nothing changed
  std::size_t false_with_debris = 0;  ///< findings far from all debris, work and traces
  std::size_t work_findings = 0;      ///< findings of planned work
  std::size_t trace_findings = 0;     ///< findings of dust, smears and fingerprints
  std::size_t big_found = 0;          ///< number of `big` that were found
  std::size_t big = 0;                ///< big pieces that count, see MovedTarget
  std::size_t large_found = 0;        ///< number of `large` that were found
  std::size_t large = 0;              ///< those among them with more than 120 visible pixels
  std::size_t found = 0;              ///< number of `targets` that were found
  std::size_t targets = 0;            ///< all pieces that count
};

/// The size from which collars are found, for one method, setting and number of captures per side.
struct CollarDetection {
  std::string method;                   ///< see MovedResult::method
  int captures = 1;                     ///< captures per side
  double setting = 0.0;                 ///< see MovedResult::setting
  double from_m = 0.0;                  ///< distance of the collars
  double to_m = 0.0;                    ///< upper end of the range of distances
  std::size_t found = 0;                ///< number of `collars` that were found
  std::size_t collars = 0;              ///< all collars that count
  std::optional<DetectionSizes> sizes;  ///< see fit_detection_sizes()
};

/// Detection of collars, in the order of the results and, for each, nearest collars first.
[[nodiscard]] std::vector<CollarDetection> collar_detection(const std::vector<MovedInspection>& inspections);

/// Totals, in the order of the results.
[[nodiscard]] std::vector<MovedTally> tally(const std::vector<MovedInspection>& inspections);

}  // namespace rva
