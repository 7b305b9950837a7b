// Summaries of a study of static methods.
#pragma once

#include <string>
#include <vector>

#include "evaluate/study.hpp"

namespace rva {

/// Counts over all inspections, for one detector and number of frames.
struct Tally {
  int frames = 0;                     ///< frames of each capture
  Detector detector;                  ///< method and setting
  std::size_t inspections = 0;        ///< number of inspections
  std::size_t false_when_clean = 0;   ///< findings where nothing changed
  std::size_t false_with_debris = 0;  ///< findings far from all debris, work and traces
  std::size_t found = 0;              ///< number of `targets` that were found
  std::size_t targets = 0;            ///< visible targets
  std::size_t found_when_clean = 0;   ///< visible targets hit by chance, by findings of the unchanged bay
  std::size_t shown_found = 0;        ///< number of `shown_targets` that were found
  std::size_t shown_targets = 0;      ///< visible targets that change the depth image, see Target::is_shown()
  std::size_t small_found = 0;        ///< number of `small_targets` that were found
  std::size_t small_targets = 0;      ///< visible collars of 0.27 in within 1 m
  std::size_t small_shown_found = 0;  ///< number of `small_shown_targets` that were found
  std::size_t small_shown_targets = 0;  ///< those among them that change the depth image
  std::size_t all_found = 0;            ///< inspections in which every visible target was found
};

/// Totals for each detector and number of frames, in the order of the results.
[[nodiscard]] std::vector<Tally> tally(const std::vector<SimulatedInspection>& inspections);

/// A table of the totals with intervals of 95 %.
[[nodiscard]] std::string to_table(const std::vector<Tally>& tallies);

}  // namespace rva
