// Findings of several views that show the same object, as one.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "inspect/inspection.hpp"

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

/// How many objects have each verdict.
struct VerdictCounts {
  std::size_t debris = 0;
  std::size_t removed = 0;
  std::size_t unreachable = 0;
  std::size_t installed = 0;
  std::size_t false_alarms = 0;
  std::size_t undecided = 0;  ///< those that need a second look, too

  void count(const std::optional<Decision>& decision);
  [[nodiscard]] std::size_t all() const {
    return debris + removed + unreachable + installed + false_alarms + undecided;
  }
};

/// Those of one comparison.
[[nodiscard]] VerdictCounts verdicts_of(const std::vector<ReviewedFinding>& findings);

}  // namespace rva
