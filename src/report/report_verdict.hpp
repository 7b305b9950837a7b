// What a report states first: whether the bay is free of debris as far as it was inspected.
#pragma once

#include <string>

#include "inspect/inspection.hpp"

namespace rva {

/// The result of an inspection, for a person with little time.
enum class Outcome {
  unfinished,   ///< not closed: nothing is stated yet
  debris_left,  ///< closed, with debris that cannot be reached
  not_shown,    ///< closed, with debris of which no captures show that it is gone, or with a lost item
  too_little,   ///< closed, with less than half of a view inspected
  clear,        ///< closed, with nothing that is debris in the last captures
};

/// The verdict that a report states first.
struct ReportVerdict {
  Outcome outcome = Outcome::unfinished;
  std::string sentence;  ///< without a full stop
  std::string reason;    ///< sentences: what was decided in each round
};

/// The verdict on an inspection. Objects are counted, not findings: what two views show counts once.
[[nodiscard]] ReportVerdict verdict_on(const InspectionHistory& history);

/// Whether a round is the last one of its inspection, on which the verdict is.
[[nodiscard]] bool is_current(const ComparedRound& round, const Inspection& inspection);

/// "Inspected: 76 % of the view; objects of 5 mm would have been found in 40 % of it": what every verdict is
/// about. Of several views, each share is the least of any. Empty before the first comparison.
[[nodiscard]] std::string extent_text(const Inspection& inspection);

}  // namespace rva
