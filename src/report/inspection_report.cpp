#include "report/inspection_report.hpp"

#include <fmt/format.h>

#include <string_view>

#include "report/report_html.hpp"
#include "report/report_style.hpp"
#include "report/report_words.hpp"

namespace rva {

std::string html_report(const ReportDocument& report, const std::string& made_at) {
  constexpr std::string_view policy = "default-src 'none'; img-src data:; style-src 'unsafe-inline'";
  Html head = Html::markup("<meta charset=\"utf-8\">");
  head += Html::markup(fmt::format("<meta http-equiv=\"Content-Security-Policy\" content=\"{}\">", policy));
  head += Html::markup("<meta name=\"viewport\" content=\"width=device-width\">");
  head += Html::element("title", Html::text(report.title + " · inspection report"));
  head += Html::element("style", Html::markup(report_style));
  const Html body = html_of(report.content + report_foot(", " + time_text(made_at)));
  const Html page = Html::markup("<!DOCTYPE html>\n<html lang=\"en\">") + Html::element("head", head) +
                    Html::element("body", body) + Html::markup("</html>\n");
  return page.str();
}

std::string inspection_report(const InspectionHistory& history, const InspectionFolder& folder,
                              const std::string& made_at) {
  return html_report(report_on(history, folder), made_at);
}

}  // namespace rva
