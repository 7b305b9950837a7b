// What a study of moved cameras says, summed up.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "evaluate/moved_study.hpp"
#include "evaluate/probability_of_detection.hpp"

namespace rva {

/// Counts over all inspections, at one setting with so many captures a side.
struct MovedTally {
  std::string method;
  int captures = 1;
  double setting = 0.0;
  std::size_t inspections = 0;
  std::size_t false_when_clean = 0;
  std::size_t false_with_debris = 0;
  std::size_t work_findings = 0;
  std::size_t trace_findings = 0;
  std::size_t big_found = 0;
  std::size_t big = 0;  ///< big pieces that count
  std::size_t large_found = 0;
  std::size_t large = 0;  ///< of those, the ones of which more than 120 pixels are visible
  std::size_t found = 0;
  std::size_t targets = 0;  ///< all that count
};

/// How large a collar has to be so that it is found, at one setting with so many captures a side.
struct CollarDetection {
  std::string method;
  int captures = 1;
  double setting = 0.0;
  double from_m = 0.0;  ///< distance of the collars
  double to_m = 0.0;
  std::size_t found = 0;
  std::size_t collars = 0;  ///< that count
  std::optional<DetectionSizes> sizes;
};

/// In the order of the results, nearest collars first.
[[nodiscard]] std::vector<CollarDetection> collar_detection(const std::vector<MovedInspection>& inspections);

/// In the order of the results.
[[nodiscard]] std::vector<MovedTally> tally(const std::vector<MovedInspection>& inspections);

/// Tables of findings, of registrations, and of what was found by kind at the usual setting, with intervals
/// of 95 %.
[[nodiscard]] std::string to_table(const std::vector<MovedInspection>& inspections);

/// `evaluation.json` of a study of moved cameras (docs/spatial.md).
/// @param arguments what the study was begun with, to go on with it
[[nodiscard]] std::string to_json(const std::vector<MovedInspection>& inspections,
                                  const std::string& arguments);

/// The inspections that are there, for a study that goes on; the pixels of their targets are not.
/// @throws Error when the text is no such evaluation; UsageError when it was begun with other arguments
[[nodiscard]] std::vector<MovedInspection> moved_inspections_from_json(const std::string& text,
                                                                       const std::string& place,
                                                                       const std::string& arguments);

}  // namespace rva
