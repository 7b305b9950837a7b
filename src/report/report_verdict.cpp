#include "report/report_verdict.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "report/object_groups.hpp"
#include "report/report_words.hpp"

namespace rva {
namespace {

VerdictCounts counts_now(const Inspection& inspection) {
  VerdictCounts counts = verdicts_of(inspection.findings);
  for (const MarkedFinding& marked : inspection.marked) counts.count(marked.decision);
  return counts;
}

// Whether no later captures show the bay without it; as closing_needs_note() counts.
bool is_removed_unseen(const std::optional<Decision>& decision, const Inspection& inspection) {
  return decision && decision->verdict == Verdict::debris_removed && inspection.final &&
         decision->round >= inspection.final->round;
}

std::size_t removed_unseen(const Inspection& inspection) {
  std::size_t unseen = 0;
  for (const ObjectGroup& group : object_groups(inspection.findings))
    if (is_removed_unseen(group.lead->decision, inspection)) ++unseen;
  for (const MarkedFinding& marked : inspection.marked)
    if (is_removed_unseen(marked.decision, inspection)) ++unseen;
  return unseen;
}

// Debris of earlier comparisons, which was removed before the last captures, and marked debris likewise.
std::size_t removed_before(const InspectionHistory& history) {
  std::size_t removed = 0;
  const auto& current = history.inspection.comparison;
  for (const ComparedRound& round : history.rounds)
    if (!current || round.comparison.number != current->number)
      removed += verdicts_of(round.findings).removed;
  VerdictCounts marked;
  for (const MarkedFinding& mark : history.inspection.marked) marked.count(mark.decision);
  return removed + marked.removed;
}

ReportVerdict unfinished(const Inspection& inspection) {
  switch (stage_of(inspection)) {
    case Stage::baseline:
      return {Outcome::unfinished, "Not finished: there is no baseline yet", "Nothing was compared."};
    case Stage::work:
      return {Outcome::unfinished, "Not finished: the bay was not compared with its latest captures",
              "Nothing is stated about debris."};
    case Stage::review:
    case Stage::done:
      break;
  }
  const VerdictCounts counts = counts_now(inspection);
  const std::size_t open = counts.undecided + counts.debris;
  return {Outcome::unfinished,
          open == 0 ? "Not finished: everything is decided, but nobody has closed the inspection"
                    : fmt::format("Not finished: {} of {} {} not settled", open,
                                  counted(counts.all(), "finding", "findings"), open == 1 ? "is" : "are"),
          fmt::format("So far: {}.", counts_text(counts))};
}

std::string closed_by(const Closing& closing) {
  return fmt::format("Closed by {}, {}.", closing.person, time_text(closing.closed_at));
}

}  // namespace

ReportVerdict verdict_on(const InspectionHistory& history) {
  const Inspection& inspection = history.inspection;
  if (!inspection.closing) return unfinished(inspection);
  const std::string closed = closed_by(*inspection.closing);
  const VerdictCounts counts = counts_now(inspection);
  const std::size_t left = counts.unreachable + counts.debris;
  if (left > 0)
    return {Outcome::debris_left,
            fmt::format("Debris remains: {}",
                        counted(left, "piece cannot be reached", "pieces cannot be reached")),
            closed};
  if (const std::size_t unseen = removed_unseen(inspection); unseen > 0)
    return {Outcome::not_shown,
            fmt::format("{} removed after the last captures, which do not show {} gone",
                        counted(unseen, "piece of debris was", "pieces of debris were"),
                        unseen == 1 ? "it" : "them"),
            closed};
  const std::size_t removed = removed_before(history);
  return {Outcome::clear, "No debris remains in what was inspected",
          removed == 0
              ? closed
              : fmt::format("{} found and removed before the last captures. {}",
                            counted(removed, "piece of debris was", "pieces of debris were"), closed)};
}

std::string extent_text(const Inspection& inspection) {
  const std::optional<double> judged = least_judged(inspection);
  if (!judged) return {};
  const std::string findable = findable_text(least_findable(inspection.compared));
  return fmt::format("Inspected: {} of the view{}{}{}", percent_text(*judged),
                     inspection.views.size() > 1 ? " with the least coverage" : "",
                     findable.empty() ? "" : "; ", findable);
}

}  // namespace rva
