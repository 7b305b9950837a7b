// Findings of several views that show the same object, as one.
#pragma once

#include <vector>

#include "inspect/inspection.hpp"
#include "inspect/verdict_counts.hpp"

namespace rva {

/// The findings of one object in the views that show it. They refer to findings of the caller.
struct ObjectGroup {
  int label = 0;                              ///< from 1 in the order of the findings, as people count them
  const ReviewedFinding* lead = nullptr;      ///< the most suspicious one, which is decided on
  std::vector<const ReviewedFinding*> all{};  ///< in the order of the findings, with `lead`
};

/// @param findings most suspicious first (rank()); must outlive what is returned
[[nodiscard]] std::vector<ObjectGroup> object_groups(const std::vector<ReviewedFinding>& findings);

/// The finding whose view shows the object best (ReviewedFinding::clear_px); the lead where that is not
/// known.
[[nodiscard]] const ReviewedFinding& best_seen(const ObjectGroup& group);

/// The verdicts on the objects of one comparison.
[[nodiscard]] VerdictCounts verdicts_of(const std::vector<ReviewedFinding>& findings);

}  // namespace rva
