#include "inspect/closing.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace rva {
namespace {

// Whether debris is not known to be gone: it cannot be reached, or no later round of captures shows the bay
// without it.
bool may_still_be_there(const std::optional<Decision>& decision, int final_round) {
  if (!decision) return false;
  if (decision->verdict == Verdict::debris_unreachable) return true;
  return decision->verdict == Verdict::debris_removed && decision->round >= final_round;
}

bool is_debris_unseen(const Inspection& inspection) {
  const int round = inspection.final ? inspection.final->round : 0;
  const auto remains = [&](const auto& finding) { return may_still_be_there(finding.decision, round); };
  return std::ranges::any_of(inspection.findings, remains) || std::ranges::any_of(inspection.marked, remains);
}

std::string title(const Inspection& inspection) { return fmt::format("inspection {}", inspection.id); }

Error missing_note(const Inspection& inspection, ClosingReason reason) {
  switch (reason) {
    case ClosingReason::debris:
      return {title(inspection), "debris was removed after the last captures, or cannot be reached",
              "capture again, or state in a note why the inspection may be closed"};
    case ClosingReason::lost_item:
      return {title(inspection), "an item of the check-out list is lost",
              "find it, or state in a note why the inspection may be closed without it"};
    case ClosingReason::coverage:
      break;
  }
  return {title(inspection), "less than half of a view was inspected",
          "capture again, or state in a note why that suffices"};
}

void require_items_accounted_for(const Inspection& inspection) {
  if (const std::size_t out = count_in(inspection.items, ItemState::out); out > 0)
    throw Error(title(inspection), fmt::format("{} item(s) of the check-out list are not accounted for", out),
                "state for each item how many were returned, used or lost");
  if (const std::size_t lost = count_in(inspection.items, ItemState::lost); lost > 0)
    throw Error(title(inspection), fmt::format("{} item(s) of the check-out list are lost", lost),
                "find them, or have an inspector release them");
}

}  // namespace

std::vector<ClosingReason> reasons_for_note(const Inspection& inspection) {
  std::vector<ClosingReason> reasons;
  if (is_debris_unseen(inspection)) reasons.push_back(ClosingReason::debris);
  if (least_judged(inspection).value_or(1.0) < least_inspected) reasons.push_back(ClosingReason::coverage);
  if (count_in(inspection.items, ItemState::released) > 0) reasons.push_back(ClosingReason::lost_item);
  return reasons;
}

Error closed_inspection(std::int64_t id, const std::string& person) {
  return {fmt::format("inspection {}", id), "has been closed by " + person, "begin a new inspection"};
}

void require_open(const Inspection& inspection) {
  if (inspection.closing) throw closed_inspection(inspection.id, inspection.closing->person);
}

void require_closable(const Inspection& inspection, const Closing& closing) {
  require_open(inspection);
  if (inspection.begun.contains(Side::final))
    throw Error(title(inspection), "the last capture was not completed", "capture again, then review it");
  if (stage_of(inspection) != Stage::review)
    throw Error(title(inspection), "has not been compared", "take both captures, then review the findings");
  if (closing.comparison != inspection.comparison->number)
    throw Error(title(inspection), "was compared again in the meantime", "review the latest findings");
  if (const std::size_t open = undecided(inspection); open > 0)
    throw Error(title(inspection),
                fmt::format("{} finding(s) are undecided, or debris that is still there", open),
                "decide on every finding");
  require_items_accounted_for(inspection);
  const std::vector<ClosingReason> reasons = reasons_for_note(inspection);
  if (closing.note.empty() && !reasons.empty()) throw missing_note(inspection, reasons.front());
}

}  // namespace rva
