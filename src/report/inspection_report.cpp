#include "report/inspection_report.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string_view>

#include "core/file_origin.hpp"
#include "report/html.hpp"
#include "report/or_reason.hpp"
#include "report/report_sections.hpp"
#include "report/report_style.hpp"
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

Html head(const Inspection& inspection) {
  Html rows;
  const auto add = [&](std::string_view name, const Html& value) {
    rows += Html::element("dt", Html::text(name)) + Html::element("dd", value);
  };
  add("Aircraft", Html::typed(inspection.order.aircraft));
  add("Zone", Html::typed(inspection.order.zone));
  add("Work order", Html::typed(inspection.order.work_order));
  add("Inspection",
      Html::text(fmt::format("{}, begun {} by ", inspection.id, time_text(inspection.created_at))) +
          Html::typed(inspection.order.person));
  return Html::element("header", Html::element("h1", Html::text("Inspection for foreign object debris")) +
                                     Html::element("dl", rows));
}

// The sign distinguishes the outcomes without colour.
std::pair<std::string_view, std::string_view> sign_and_class(Outcome outcome) {
  switch (outcome) {
    case Outcome::clear:
      return {"✓", "verdict clear"};
    case Outcome::debris_left:
      return {"✗", "verdict bad"};
    case Outcome::not_shown:
    case Outcome::too_little:
      return {"!", "verdict warn"};
    case Outcome::unfinished:
      break;
  }
  return {"…", "verdict open"};
}

// What was decided in each round, and the closing. A note is quoted, so that it cannot be taken for a
// statement of the program.
Html reasons_of(const ReportVerdict& verdict, const std::optional<Closing>& closing) {
  Html line = Html::text(verdict.reason);
  if (!closing) return Html::element("p", line);
  line += Html::text(" Closed by ") + Html::typed(closing->person) +
          Html::text(fmt::format(", {}.", time_text(closing->closed_at)));
  const Html note = closing->note.empty() ? Html() : Html::element("blockquote", Html::typed(closing->note));
  return Html::element("p", line) + note;
}

// @param body the sections that follow
Html verdict(const InspectionHistory& history, const Html& body) {
  const ReportVerdict verdict = verdict_on(history);
  const auto [sign, class_name] = sign_and_class(verdict.outcome);
  Html content = Html::element(
      "p", Html::text(fmt::format("{} ", sign)) + Html::text(verdict.sentence) + Html::text("."), "sentence");
  if (const std::string extent = extent_text(history.inspection); !extent.empty())
    content += Html::element("p", Html::text(extent + "."));
  if (const std::size_t missing = count_reasons(body); missing > 0)
    content +=
        Html::element("p",
                      Html::text(fmt::format("{} of this record cannot be shown; the reason is in its place.",
                                             counted(missing, "part", "parts"))),
                      "missing");
  content += reasons_of(verdict, history.inspection.closing);
  return Html::element("section", content, class_name);
}

// The program that made the document, and that it alone proves nothing.
Html foot(const std::string& made_at) {
  const nlohmann::ordered_json origin = provenance_json(made_at);
  return Html::element(
      "footer",
      Html::text(fmt::format(
          "Made by {} {}, {}. Whether it is as it was written is shown by the signed package of the "
          "inspection (rva inspection verify), not by this page alone.",
          origin.value("program", ""), origin.value("version", ""), time_text(made_at))));
}

Html document(const InspectionHistory& history, const Html& body) {
  constexpr std::string_view policy = "default-src 'none'; img-src data:; style-src 'unsafe-inline'";
  Html page = Html::markup("<meta charset=\"utf-8\">");
  page += Html::markup(fmt::format("<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">", policy));
  page += Html::markup("<meta name=\"viewport\" content=\"width=device-width\">");
  page += Html::element("title", Html::text(title_of(history.inspection) + " · inspection report"));
  page += Html::element("style", Html::markup(report_style));
  return Html::markup("<!DOCTYPE html>\n<html lang=\"en\">") + Html::element("head", page) +
         Html::element("body", body) + Html::markup("</html>\n");
}

}  // namespace

std::string inspection_report(const InspectionHistory& history, const InspectionFolder& folder,
                              const std::string& made_at) {
  Html body = coverage_section(history, folder);
  body += findings_section(history, folder);
  body += events_section(history);
  body += settings_section(history, folder);
  body += checksums_section(history, folder);
  return document(history, head(history.inspection) + verdict(history, body) + body + foot(made_at)).str();
}

}  // namespace rva
