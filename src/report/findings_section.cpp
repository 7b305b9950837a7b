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

Html decision_of(const std::optional<Decision>& decision) {
  if (!decision) return Html::element("p", Html::text(verdict_text(Verdict::undecided)), "decision open");
  Html text = Html::element("strong", Html::text(verdict_text(decision->verdict)));
  if (!decision->object.empty()) text += Html::text(" (") + Html::typed(decision->object) + Html::text(")");
  if (!decision->note.empty()) text += Html::text(": ") + Html::typed(decision->note);
  text +=
      Html::text(" — ") + Html::typed(decision->person) + Html::text(", " + time_text(decision->decided_at));
  return Html::element("p", text, is_settled(decision) ? "decision" : "decision open");
}

Html title(const std::string& label, std::string_view what) {
  return Html::element("h3", Html::text(label + " · ") + Html::typed(what));
}

std::string views_of(const ObjectGroup& group) {
  std::vector<int> views;
  for (const ReviewedFinding* const finding : group.all) views.push_back(finding->view + 1);
  std::ranges::sort(views);
  views.erase(std::ranges::unique(views).begin(), views.end());
  return fmt::format("View{} {}", views.size() > 1 ? "s" : "", fmt::join(views, ", "));
}

Html of_object(const ObjectGroup& group, ComparisonPictures& pictures) {
  const ReviewedFinding& lead = *group.lead;
  std::vector<std::string> known{views_of(group)};
  for (const std::string& text : {measures_text(lead.finding), class_text(lead)})
    if (!text.empty()) known.push_back(text);
  Html content = title(std::to_string(group.label), change_text(lead));
  content += Html::element("p", Html::text(fmt::format("{}", fmt::join(known, "; "))));
  content += decision_of(lead.decision);
  if (pictures.exist())
    content += or_reason([&] { return pictures.before_and_after(best_seen(group)); });
  else
    content += Html::element("p", Html::text("Its pictures were replaced by those of a later comparison."));
  return Html::element("section", content, "finding");
}

Html of_mark(const MarkedFinding& marked, const InspectionFolder& folder) {
  Html content = title(fmt::format("Marked finding {}", marked.number), marked.note);
  content += Html::element("p", Html::text("Marked by ") + Html::typed(marked.person) +
                                    Html::text(", " + time_text(marked.marked_at)));
  content += decision_of(marked.decision);
  content += or_reason([&] { return marked_picture(folder, marked); });
  return Html::element("section", content, "finding");
}

bool is_planned(const ObjectGroup& group) { return group.lead->planned == PlannedState::planned; }

// "24 of 24 collars: Installed work, Ann"; planned parts are decided on together.
Html planned_work(const ComparedRound& round, const std::vector<ObjectGroup>& groups) {
  HtmlTable table{.head = {Html::text("Planned"), Html::text("Found"), Html::text("Missing"),
                           Html::text("Not inspected"), Html::text("Decided")},
                  .rows = {},
                  .class_name = {}};
  for (const ComparedView& view : round.compared)
    for (const PlannedWork& work : view.planned) {
      VerdictCounts counts;
      for (const ObjectGroup& group : groups)
        if (is_planned(group) && group.lead->view == view.view && group.lead->planned_item == work.name)
          counts.count(group.lead->decision);
      table.rows.push_back({Html::typed(work.name) + Html::text(fmt::format(" (view {})", view.view + 1)),
                            Html::text(fmt::format("{} of {}", work.found, work.planned)),
                            Html::text(std::to_string(work.missing)),
                            Html::text(std::to_string(work.not_inspected)),
                            Html::text(counts.all() == 0 ? "–" : counts_text(counts))});
    }
  return table.rows.empty() ? Html() : html_of(table);
}

std::string round_title(std::size_t number, const InspectionHistory& history, const ComparedRound& round) {
  return fmt::format("Findings of round {}{}, {}: {}", number,
                     is_current(round, history.inspection) ? " (the last)" : "",
                     time_text(round.comparison.compared_at), counts_text(verdicts_of(round.findings)));
}

Html of_round(const InspectionHistory& history, std::size_t newest_first, const InspectionFolder& folder) {
  const ComparedRound& round = history.rounds[newest_first];
  const std::vector<ObjectGroup> groups = object_groups(round.findings);
  ComparisonPictures pictures(folder, round.comparison);
  Html content =
      Html::element("h2", Html::text(round_title(history.rounds.size() - newest_first, history, round)));
  content += planned_work(round, groups);
  for (const ObjectGroup& group : groups)
    if (!is_planned(group)) content += of_object(group, pictures);
  return content;
}

Html marks_of(const Inspection& inspection, const InspectionFolder& folder) {
  if (inspection.marked.empty()) return {};
  Html content = Html::element("h2", Html::text("Marked by people"));
  for (const MarkedFinding& marked : inspection.marked) content += of_mark(marked, folder);
  return content;
}

Html snapshots_of(const Inspection& inspection, const InspectionFolder& folder) {
  if (inspection.snapshots.empty()) return {};
  Html figures;
  for (const Snapshot& snapshot : inspection.snapshots)
    figures += Html::element(
        "figure", or_reason([&] { return snapshot_picture(folder, snapshot); }) +
                      Html::element("figcaption", Html::typed(snapshot.note) + Html::text(" — ") +
                                                      Html::typed(snapshot.person) +
                                                      Html::text(", " + time_text(snapshot.taken_at))));
  return Html::element("h2", Html::text("Snapshots")) + Html::element("div", figures, "pictures two");
}

}  // namespace

Html findings_section(const InspectionHistory& history, const InspectionFolder& folder) {
  Html content;
  for (std::size_t k = 0; k < history.rounds.size(); ++k) content += of_round(history, k, folder);
  return content + marks_of(history.inspection, folder) + snapshots_of(history.inspection, folder);
}

}  // namespace rva
