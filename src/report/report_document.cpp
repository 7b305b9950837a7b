#include "report/report_document.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string_view>
#include <utility>

#include "core/file_origin.hpp"
#include "report/or_reason.hpp"
#include "report/report_sections.hpp"
#include "report/report_verdict.hpp"
#include "report/report_words.hpp"

namespace rva {
namespace {

std::string title_of(const Inspection& inspection) {
  std::string title;
  for (const std::string& part :
       {inspection.order.aircraft, inspection.order.zone, inspection.order.work_order})
    if (!part.empty()) title += (title.empty() ? "" : " · ") + part;
  return title.empty() ? fmt::format("Inspection {}", inspection.id) : title;
}

Content head(const Inspection& inspection) {
  Content rows;
  const auto add = [&](std::string_view name, const Content& value) {
    rows +=
        Content::of(PartRole::field_name, Content::text(name)) + Content::of(PartRole::field_value, value);
  };
  add("Aircraft", Content::typed(inspection.order.aircraft));
  add("Zone", Content::typed(inspection.order.zone));
  add("Work order", Content::typed(inspection.order.work_order));
  add("Inspection",
      Content::text(fmt::format("{}, begun {} by ", inspection.id, time_text(inspection.created_at))) +
          Content::typed(inspection.order.person));
  return Content::of(PartRole::head,
                     Content::of(PartRole::title, Content::text("Inspection for foreign object debris")) +
                         Content::of(PartRole::fields, rows));
}

// The sign distinguishes the outcomes without colour.
std::pair<std::string_view, PartRole> sign_and_role(Outcome outcome) {
  switch (outcome) {
    case Outcome::clear:
      return {"✓", PartRole::verdict_clear};
    case Outcome::debris_left:
      return {"✗", PartRole::verdict_bad};
    case Outcome::not_shown:
    case Outcome::too_little:
      return {"!", PartRole::verdict_warning};
    case Outcome::unfinished:
      break;
  }
  return {"…", PartRole::verdict_open};
}

// What was decided in each round, and the closing. A note is quoted, so that it cannot be taken for a
// statement of the program.
Content reasons_of(const ReportVerdict& verdict, const std::optional<Closing>& closing) {
  Content line = Content::text(verdict.reason);
  if (!closing) return Content::of(PartRole::paragraph, line);
  line += Content::text(" Closed by ") + Content::typed(closing->person) +
          Content::text(fmt::format(", {}.", time_text(closing->closed_at)));
  const Content note =
      closing->note.empty() ? Content() : Content::of(PartRole::note, Content::typed(closing->note));
  return Content::of(PartRole::paragraph, line) + note;
}

// @param body the sections that follow
Content verdict(const InspectionHistory& history, const Content& body) {
  const ReportVerdict verdict = verdict_on(history);
  const auto [sign, role] = sign_and_role(verdict.outcome);
  Content content = Content::of(PartRole::sentence, Content::text(fmt::format("{} ", sign)) +
                                                        Content::text(verdict.sentence) + Content::text("."));
  if (const std::string extent = extent_text(history.inspection); !extent.empty())
    content += Content::of(PartRole::paragraph, Content::text(extent + "."));
  if (const std::size_t missing = count_of(PartRole::missing, body); missing > 0)
    content += Content::of(
        PartRole::missing,
        Content::text(fmt::format("{} of this record cannot be shown; the reason is in its place.",
                                  counted(missing, "part", "parts"))));
  content += reasons_of(verdict, history.inspection.closing);
  return Content::of(role, content);
}

}  // namespace

ReportDocument report_on(const InspectionHistory& history, const InspectionFolder& folder) {
  Content body = coverage_section(history, folder);
  body += findings_section(history, folder);
  body += items_section(history.inspection);
  body += events_section(history);
  body += settings_section(history, folder);
  body += checksums_section(history, folder);
  return {.inspection = history.inspection.id,
          .title = title_of(history.inspection),
          .content = head(history.inspection) + verdict(history, body) + body,
          .last_action_at = last_action_at(history)};
}

std::string program_text() {
  const nlohmann::ordered_json origin = provenance_json("");
  return fmt::format("{} {}", origin.value("program", ""), origin.value("version", ""));
}

Content report_foot(const std::string& made) {
  return Content::of(
      PartRole::foot,
      Content::text(
          fmt::format("Made by {}{}. Whether it is as it was written is shown by the signed package of the "
                      "inspection (rva inspection verify), not by this page alone.",
                      program_text(), made)));
}

}  // namespace rva
