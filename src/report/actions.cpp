#include "report/actions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "report/object_groups.hpp"
#include "report/report_words.hpp"

namespace rva {
namespace {

// What a decision is on, as people count: "round 2, finding 3"; "marked finding 1".
struct Subject {
  std::size_t round = 0;  ///< 0: marked findings
  int label = 0;
};

// By the numbers of the comparison and of the finding.
using Subjects = std::map<std::pair<int, int>, Subject>;

Subjects subjects_of(const InspectionHistory& history) {
  Subjects subjects;
  for (std::size_t k = 0; k < history.rounds.size(); ++k)
    for (const ObjectGroup& group : object_groups(history.rounds[k].findings))
      for (const ReviewedFinding* const finding : group.all)
        subjects[{history.rounds[k].comparison.number, finding->number}] = {history.rounds.size() - k,
                                                                            group.label};
  return subjects;
}

Subject subject_of(const RecordedDecision& decision, const Subjects& subjects) {
  const auto found = subjects.find({decision.comparison, decision.finding});
  return found == subjects.end() ? Subject{0, decision.finding} : found->second;
}

// Decisions that a person made alike, one after another within a minute.
struct SameDecisions {
  const Decision* decision = nullptr;
  std::size_t round = 0;
  std::vector<std::string> labels{};

  [[nodiscard]] bool is_like(const Decision& other, std::size_t other_round) const {
    return round == other_round && decision->verdict == other.verdict && decision->person == other.person &&
           decision->note == other.note && decision->object == other.object &&
           time_text(decision->decided_at) == time_text(other.decided_at);
  }
};

std::vector<SameDecisions> same_decisions(const InspectionHistory& history) {
  const Subjects subjects = subjects_of(history);
  std::vector<SameDecisions> rows;
  for (const RecordedDecision& recorded : history.decisions) {
    const Subject subject = subject_of(recorded, subjects);
    if (rows.empty() || !rows.back().is_like(recorded.decision, subject.round))
      rows.push_back({&recorded.decision, subject.round});
    std::vector<std::string>& labels = rows.back().labels;
    const std::string label = std::to_string(subject.label);
    if (std::ranges::find(labels, label) == labels.end()) labels.push_back(label);
  }
  return rows;
}

Content text_of(const SameDecisions& same) {
  const std::string of =
      same.round == 0 ? "Decided, marked finding" : fmt::format("Decided, round {}, finding", same.round);
  Content text = Content::text(
      fmt::format("{}{} {}: {}", of, same.labels.size() > 1 ? "s" : "", listed(same.labels),
                  same.decision->verdict == Verdict::undecided ? "decision taken back"
                                                               : verdict_text(same.decision->verdict)));
  if (!same.decision->object.empty())
    text += Content::text(" (") + Content::typed(same.decision->object) + Content::text(")");
  if (!same.decision->note.empty()) text += Content::text(", ") + Content::typed(same.decision->note);
  return text;
}

void add_captures(const InspectionHistory& history, std::vector<Action>& actions) {
  for (const CapturedRound& round : history.captured)
    actions.push_back(
        {round.taken.taken_at, round.taken.person,
         Content::text(round.side == Side::initial ? "Baseline captured" : "Bay after the work captured")});
  for (std::size_t k = 0; k < history.rounds.size(); ++k) {
    const ComparedRound& round = history.rounds[k];
    actions.push_back(
        {round.comparison.compared_at, "",
         Content::text(fmt::format("Round {} compared: {}", history.rounds.size() - k,
                                   counted(object_groups(round.findings).size(), "finding", "findings")))});
  }
}

void add_remarks(const Inspection& inspection, std::vector<Action>& actions) {
  for (const MarkedFinding& marked : inspection.marked)
    actions.push_back({marked.marked_at, marked.person,
                       Content::text(fmt::format("Marked a finding, number {}: ", marked.number)) +
                           Content::typed(marked.note)});
  for (const Snapshot& snapshot : inspection.snapshots)
    actions.push_back(
        {snapshot.taken_at, snapshot.person,
         Content::text(fmt::format("Kept snapshot {}: ", snapshot.number)) + Content::typed(snapshot.note)});
}

// Items that a person took in at once are one row.
void add_items(const Inspection& inspection, std::vector<Action>& actions) {
  std::map<std::pair<std::string, std::string>, std::size_t> taken;
  for (const CheckedOutItem& item : inspection.items) {
    ++taken[{item.taken_at, item.person}];
    for (const ItemStatement& statement : item.statements) {
      Content text =
          Content::text(fmt::format("Item {} of the check-out list, ", item.number)) +
          Content::typed(item.item.name) +
          Content::text(fmt::format(": {} returned, {} used or installed, {} lost{}", statement.returned,
                                    statement.used, statement.lost, statement.released ? ", released" : ""));
      if (!statement.note.empty()) text += Content::text(", ") + Content::typed(statement.note);
      actions.push_back({statement.stated_at, statement.person, text});
    }
  }
  for (const auto& [key, count] : taken)
    actions.push_back({key.first, key.second,
                       Content::text(counted(count, "item", "items") + " listed as taken into the bay")});
}

}  // namespace

std::vector<Action> actions_of(const InspectionHistory& history) {
  const Inspection& inspection = history.inspection;
  std::vector<Action> actions{
      {inspection.created_at, inspection.order.person, Content::text("Inspection begun")}};
  add_captures(history, actions);
  add_remarks(inspection, actions);
  add_items(inspection, actions);
  for (const SameDecisions& same : same_decisions(history))
    actions.push_back({same.decision->decided_at, same.decision->person, text_of(same)});
  if (const auto& closing = inspection.closing) {
    Content text = Content::text("Inspection closed");
    if (!closing->note.empty()) text += Content::text(", ") + Content::typed(closing->note);
    actions.push_back({closing->closed_at, closing->person, text});
  }
  std::ranges::stable_sort(actions, {}, &Action::at);
  return actions;
}

}  // namespace rva
