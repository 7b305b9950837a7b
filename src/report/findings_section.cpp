#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "report/object_groups.hpp"
#include "report/or_reason.hpp"
#include "report/report_pictures.hpp"
#include "report/report_sections.hpp"
#include "report/report_verdict.hpp"
#include "report/report_words.hpp"

namespace rva {
namespace {

Content decision_of(const std::optional<Decision>& decision) {
  if (!decision) return Content::of(PartRole::open_decision, Content::text(verdict_text(Verdict::undecided)));
  Content text = Content::of(PartRole::strong, Content::text(verdict_text(decision->verdict)));
  if (!decision->object.empty())
    text += Content::text(" (") + Content::typed(decision->object) + Content::text(")");
  if (!decision->note.empty()) text += Content::text(": ") + Content::typed(decision->note);
  text += Content::text(" — ") + Content::typed(decision->person) +
          Content::text(", " + time_text(decision->decided_at));
  return Content::of(is_settled(decision) ? PartRole::decision : PartRole::open_decision, text);
}

Content title(const std::string& label, std::string_view what) {
  return Content::of(PartRole::finding_title, Content::text(label + " · ") + Content::typed(what));
}

std::string views_of(const ObjectGroup& group) {
  std::vector<int> views;
  for (const ReviewedFinding* const finding : group.all) views.push_back(finding->view + 1);
  std::ranges::sort(views);
  views.erase(std::ranges::unique(views).begin(), views.end());
  return fmt::format("View{} {}", views.size() > 1 ? "s" : "", fmt::join(views, ", "));
}

Content of_object(const ObjectGroup& group, ComparisonPictures& pictures) {
  const ReviewedFinding& lead = *group.lead;
  std::vector<std::string> known{views_of(group)};
  for (const std::string& text : {measures_text(lead.finding), class_text(lead)})
    if (!text.empty()) known.push_back(text);
  Content content = title(std::to_string(group.label), change_text(lead));
  content += Content::of(PartRole::paragraph, Content::text(fmt::format("{}", fmt::join(known, "; "))));
  content += decision_of(lead.decision);
  if (pictures.exist())
    content += or_reason([&] { return pictures.before_and_after(best_seen(group)); });
  else
    content += Content::of(PartRole::paragraph,
                           Content::text("Its pictures were replaced by those of a later comparison."));
  return Content::of(PartRole::finding, content);
}

Content of_mark(const MarkedFinding& marked, const InspectionFolder& folder) {
  Content content = title(fmt::format("Marked finding {}", marked.number), marked.note);
  content += Content::of(PartRole::paragraph, Content::text("Marked by ") + Content::typed(marked.person) +
                                                  Content::text(", " + time_text(marked.marked_at)));
  content += decision_of(marked.decision);
  content += or_reason([&] { return marked_picture(folder, marked); });
  return Content::of(PartRole::finding, content);
}

bool is_planned(const ObjectGroup& group) { return group.lead->planned == PlannedState::planned; }

// "24 of 24 collars: Installed work, Ann"; planned parts are decided on together.
Content planned_work(const ComparedRound& round, const std::vector<ObjectGroup>& groups) {
  ReportTable table{.role = PartRole::table,
                    .head = {Content::text("Planned"), Content::text("Found"), Content::text("Missing"),
                             Content::text("Not inspected"), Content::text("Decided")},
                    .rows = {}};
  for (const ComparedView& view : round.compared)
    for (const PlannedWork& work : view.planned) {
      VerdictCounts counts;
      for (const ObjectGroup& group : groups)
        if (is_planned(group) && group.lead->view == view.view && group.lead->planned_item == work.name)
          counts.count(group.lead->decision);
      table.rows.push_back(
          {Content::typed(work.name) + Content::text(fmt::format(" (view {})", view.view + 1)),
           Content::text(fmt::format("{} of {}", work.found, work.planned)),
           Content::text(std::to_string(work.missing)), Content::text(std::to_string(work.not_inspected)),
           Content::text(counts.all() == 0 ? "–" : counts_text(counts))});
    }
  return table.rows.empty() ? Content() : content_of(table);
}

std::string round_title(std::size_t number, const InspectionHistory& history, const ComparedRound& round) {
  return fmt::format("Findings of round {}{}, {}: {}", number,
                     is_current(round, history.inspection) ? " (the last)" : "",
                     time_text(round.comparison.compared_at), counts_text(verdicts_of(round.findings)));
}

Content of_round(const InspectionHistory& history, std::size_t newest_first, const InspectionFolder& folder) {
  const ComparedRound& round = history.rounds[newest_first];
  const std::vector<ObjectGroup> groups = object_groups(round.findings);
  ComparisonPictures pictures(folder, round.comparison);
  Content content = Content::of(
      PartRole::heading, Content::text(round_title(history.rounds.size() - newest_first, history, round)));
  content += planned_work(round, groups);
  for (const ObjectGroup& group : groups)
    if (!is_planned(group)) content += of_object(group, pictures);
  return content;
}

Content marks_of(const Inspection& inspection, const InspectionFolder& folder) {
  if (inspection.marked.empty()) return {};
  Content content = Content::of(PartRole::heading, Content::text("Marked by people"));
  for (const MarkedFinding& marked : inspection.marked) content += of_mark(marked, folder);
  return content;
}

Content snapshots_of(const Inspection& inspection, const InspectionFolder& folder) {
  if (inspection.snapshots.empty()) return {};
  Content figures;
  for (const Snapshot& snapshot : inspection.snapshots)
    figures += Content::of(
        PartRole::figure,
        or_reason([&] { return snapshot_picture(folder, snapshot); }) +
            Content::of(PartRole::caption, Content::typed(snapshot.note) + Content::text(" — ") +
                                               Content::typed(snapshot.person) +
                                               Content::text(", " + time_text(snapshot.taken_at))));
  return Content::of(PartRole::heading, Content::text("Snapshots")) +
         Content::of(PartRole::two_figures, figures);
}

}  // namespace

Content findings_section(const InspectionHistory& history, const InspectionFolder& folder) {
  Content content;
  for (std::size_t k = 0; k < history.rounds.size(); ++k) content += of_round(history, k, folder);
  return content + marks_of(history.inspection, folder) + snapshots_of(history.inspection, folder);
}

}  // namespace rva
