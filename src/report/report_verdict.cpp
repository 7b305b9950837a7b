#include "report/report_verdict.hpp"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "inspect/closing.hpp"
#include "report/object_groups.hpp"
#include "report/report_words.hpp"

namespace rva {
namespace {

VerdictCounts counts_now(const Inspection& inspection) {
  VerdictCounts counts = verdicts_of(inspection.findings);
  for (const MarkedFinding& marked : inspection.marked) counts.count(marked.decision);
  return counts;
}

// Whether no later captures show the bay without it; as ClosingReason::debris counts.
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

// Debris of earlier rounds that nobody could reach. Where later rounds do not show it, something moved it.
std::size_t unreachable_before(const InspectionHistory& history) {
  std::size_t unreachable = 0;
  for (const ComparedRound& round : history.rounds)
    if (!is_current(round, history.inspection)) unreachable += verdicts_of(round.findings).unreachable;
  return unreachable;
}

// "Round 1: 4 debris removed. Round 2: nothing found." An object counts in each round that found it.
std::string rounds_text(const InspectionHistory& history) {
  std::vector<std::string> sentences;
  for (auto round = history.rounds.rbegin(); round != history.rounds.rend(); ++round)
    sentences.push_back(
        fmt::format("Round {}: {}.", sentences.size() + 1, counts_text(verdicts_of(round->findings))));
  VerdictCounts marked;
  for (const MarkedFinding& mark : history.inspection.marked) marked.count(mark.decision);
  if (marked.all() > 0) sentences.push_back(fmt::format("Marked by people: {}.", counts_text(marked)));
  return fmt::format("{}", fmt::join(sentences, " "));
}

std::string unfinished_sentence(const Inspection& inspection) {
  switch (stage_of(inspection)) {
    case Stage::baseline:
      return "Not finished: there is no baseline yet";
    case Stage::work:
      return "Not finished: the bay was not compared with its latest captures";
    case Stage::review:
    case Stage::done:
      break;
  }
  const VerdictCounts counts = counts_now(inspection);
  const std::size_t open = counts.undecided + counts.debris;
  const std::size_t items =
      count_in(inspection.items, ItemState::out) + count_in(inspection.items, ItemState::lost);
  if (open == 0 && items > 0)
    return fmt::format("Not finished: {} not accounted for",
                       counted(items, "item of the check-out list is", "items of the check-out list are"));
  return open == 0 ? "Not finished: everything is decided, but nobody has closed the inspection"
                   : fmt::format("Not finished: {} of {} {} not settled", open,
                                 counted(counts.all(), "finding", "findings"), open == 1 ? "is" : "are");
}

struct StatedOutcome {
  Outcome outcome;
  std::string sentence;
};

// The worst that applies to a closed inspection.
StatedOutcome closed_outcome(const InspectionHistory& history) {
  const Inspection& inspection = history.inspection;
  const VerdictCounts counts = counts_now(inspection);
  if (const std::size_t left = counts.unreachable + counts.debris; left > 0)
    return {Outcome::debris_left, fmt::format("Debris remains: {}", counted(left, "piece was not removed",
                                                                            "pieces were not removed"))};
  if (counts.undecided > 0)
    return {Outcome::not_shown, fmt::format("Closed, although {} not settled",
                                            counted(counts.undecided, "finding is", "findings are"))};
  if (const std::size_t unseen = removed_unseen(inspection); unseen > 0)
    return {Outcome::not_shown, fmt::format("{} removed after the last captures, which do not show {} gone",
                                            counted(unseen, "piece of debris was", "pieces of debris were"),
                                            unseen == 1 ? "it" : "them")};
  if (const std::size_t gone = unreachable_before(history); gone > 0)
    return {Outcome::not_shown,
            fmt::format("{} not be reached in an earlier round, and the last captures do not show {}",
                        counted(gone, "piece of debris could", "pieces of debris could"),
                        gone == 1 ? "it" : "them")};
  if (const std::size_t lost = count_in(inspection.items, ItemState::released); lost > 0)
    return {Outcome::not_shown,
            fmt::format("{} lost, and may be in the bay",
                        counted(lost, "item of the check-out list is", "items of the check-out list are"))};
  if (least_judged(inspection).value_or(0.0) < least_inspected)
    return {Outcome::too_little, "No debris was left where it was inspected, but most of a view was not"};
  return {Outcome::clear, "No debris remains in what was inspected"};
}

}  // namespace

bool is_current(const ComparedRound& round, const Inspection& inspection) {
  return inspection.comparison && inspection.comparison->number == round.comparison.number;
}

ReportVerdict verdict_on(const InspectionHistory& history) {
  const StatedOutcome stated =
      history.inspection.closing
          ? closed_outcome(history)
          : StatedOutcome{Outcome::unfinished, unfinished_sentence(history.inspection)};
  return {stated.outcome, stated.sentence, rounds_text(history)};
}

std::string extent_text(const Inspection& inspection) {
  const std::optional<double> judged = least_judged(inspection);
  if (!judged) return {};
  const bool is_one_view = inspection.views.size() == 1;
  const std::string inspected = percent_text(*judged);
  const std::string findable = findable_text(least_findable(inspection.compared), is_one_view);
  return fmt::format("Inspected: {}{}{}",
                     is_one_view ? inspected + " of the view" : "at least " + inspected + " of each view",
                     findable.empty() ? "" : "; ", findable);
}

}  // namespace rva
