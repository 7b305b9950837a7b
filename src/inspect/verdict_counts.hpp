// How many objects have each verdict.
#pragma once

#include <cstddef>
#include <optional>

#include "inspect/reviewed_finding.hpp"

namespace rva {

/// Numbers of objects by verdict.
struct VerdictCounts {
  std::size_t debris = 0;  ///< which is still there
  std::size_t removed = 0;
  std::size_t unreachable = 0;
  std::size_t installed = 0;
  std::size_t false_alarms = 0;
  std::size_t undecided = 0;  ///< those that need a second look, too

  void add(Verdict verdict, std::size_t objects);
  /// Adds an object with the decision on it, if there is one.
  void count(const std::optional<Decision>& decision);
  VerdictCounts& operator+=(const VerdictCounts& more);
  /// Debris, whatever became of it.
  [[nodiscard]] std::size_t any_debris() const { return debris + removed + unreachable; }
  [[nodiscard]] std::size_t all() const { return any_debris() + installed + false_alarms + undecided; }
  bool operator==(const VerdictCounts&) const = default;
};

}  // namespace rva
