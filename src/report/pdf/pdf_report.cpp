#include "report/pdf/pdf_report.hpp"

#include <cairo-pdf.h>
#include <fmt/format.h>

#include <algorithm>
#include <cstddef>
#include <iterator>
#include <memory>
#include <utility>
#include <vector>

#include "core/date_time.hpp"
#include "core/error.hpp"
#include "report/pdf/pdf_blocks.hpp"
#include "report/pdf/pdf_pages.hpp"
#include "report/pdf/pdf_text.hpp"
#include "report/pdf/pdf_update.hpp"
#include "report/report_words.hpp"

namespace rva {
namespace {

using pdf::pt_per_mm;

constexpr double side_pt = 13.0 * pt_per_mm;
constexpr double top_pt = 11.0 * pt_per_mm;
constexpr double bottom_pt = 17.0 * pt_per_mm;  // with the line that each page ends with
constexpr double last_line_pt = 12.0 * pt_per_mm;

struct PaperSize {
  double width_pt;
  double height_pt;
};

PaperSize size_of(Paper paper) {
  constexpr PaperSize a4{210.0 * pt_per_mm, 297.0 * pt_per_mm};
  constexpr PaperSize letter{8.5 * 72.0, 11.0 * 72.0};
  return paper == Paper::a4 ? a4 : letter;
}

cairo_status_t append(void* file, const unsigned char* bytes, unsigned int count) {
  static_cast<std::string*>(file)->append(reinterpret_cast<const char*>(bytes), count);
  return CAIRO_STATUS_SUCCESS;
}

// Without a time that it understands, cairo states the present one.
std::string stated_time(const std::string& iso_8601) {
  constexpr std::size_t seconds = 19;
  return (ns_since_1970(iso_8601) ? iso_8601.substr(0, seconds) : "1970-01-01T00:00:00") + "Z";
}

void set_metadata(cairo_surface_t* surface, const ReportDocument& report) {
  const auto set = [&](cairo_pdf_metadata_t which, const std::string& text) {
    cairo_pdf_surface_set_metadata(surface, which, text.c_str());
  };
  set(CAIRO_PDF_METADATA_TITLE, shown_text(report.title + " · inspection report"));
  set(CAIRO_PDF_METADATA_SUBJECT, fmt::format("Inspection {}", report.inspection));
  set(CAIRO_PDF_METADATA_CREATOR, program_text());
  set(CAIRO_PDF_METADATA_CREATE_DATE, stated_time(report.last_action_at));
  set(CAIRO_PDF_METADATA_MOD_DATE, stated_time(report.last_action_at));
}

// The foot follows what is before it to the next page, so that it is not alone there.
std::vector<pdf::Box> boxes_of_report(const ReportDocument& report, const pdf::Setting& setting) {
  std::vector<pdf::Box> boxes = pdf::boxes_of(report.content, setting);
  if (!boxes.empty()) boxes.back().keeps_with_next = true;
  const Content foot =
      report_foot(fmt::format(" from the records as they were after {}", time_text(report.last_action_at)));
  std::ranges::move(pdf::boxes_of(foot, setting), std::back_inserter(boxes));
  return boxes;
}

/// What the pages of a report have in common.
struct Sheet {
  PaperSize size;
  const pdf::TextSetter& text;
  std::string name;  ///< of the inspection, on each page

  [[nodiscard]] double width_pt() const { return size.width_pt - 2.0 * side_pt; }
  [[nodiscard]] double height_pt() const { return size.height_pt - top_pt - bottom_pt; }
};

void draw_page(cairo_t* cairo, const Sheet& sheet, const pdf::Page& page, const std::string& number) {
  for (const pdf::PlacedBox& placed : page) pdf::draw(placed.box, cairo, side_pt, top_pt + placed.top_pt);
  constexpr pdf::TextStyle style{
      .size_pt = 7.5, .ink = {0.27, 0.27, 0.27}, .is_bold = false, .is_italic = false};
  const double y_pt = sheet.size.height_pt - last_line_pt;
  const Content right = Content::text(number);
  const double right_pt = sheet.text.width_pt(right, style);
  const double gap_pt = 5.0 * pt_per_mm;
  pdf::draw(sheet.text.one_line(Content::typed(sheet.name), style, sheet.width_pt() - right_pt - gap_pt),
            cairo, side_pt, y_pt);
  pdf::draw(sheet.text.one_line(right, style, right_pt), cairo, side_pt + sheet.width_pt() - right_pt, y_pt);
  cairo_show_page(cairo);
}

void require_drawn(cairo_status_t status) {
  if (status != CAIRO_STATUS_SUCCESS)
    throw Error("PDF", fmt::format("cannot be drawn: {}", cairo_status_to_string(status)),
                "write the HTML report, and report this as an error of RVA");
}

std::string drawn(const ReportDocument& report, const Sheet& sheet, const std::vector<pdf::Page>& pages) {
  std::string file;
  const std::unique_ptr<cairo_surface_t, decltype(&cairo_surface_destroy)> surface(
      cairo_pdf_surface_create_for_stream(append, &file, sheet.size.width_pt, sheet.size.height_pt),
      cairo_surface_destroy);
  // Later versions may compress the cross-reference table, which an update has to read.
  cairo_pdf_surface_restrict_to_version(surface.get(), CAIRO_PDF_VERSION_1_4);
  set_metadata(surface.get(), report);
  const std::unique_ptr<cairo_t, decltype(&cairo_destroy)> cairo(cairo_create(surface.get()), cairo_destroy);
  for (std::size_t k = 0; k < pages.size(); ++k)
    draw_page(cairo.get(), sheet, pages[k], fmt::format("Page {} of {}", k + 1, pages.size()));
  require_drawn(cairo_status(cairo.get()));
  cairo_surface_finish(surface.get());
  require_drawn(cairo_surface_status(surface.get()));
  return file;
}

}  // namespace

std::string pdf_report(const ReportDocument& report, Paper paper) {
  const pdf::TextSetter text;
  std::string name = fmt::format("Inspection {}", report.inspection);
  if (name != report.title) name += " · " + report.title;
  const Sheet sheet{size_of(paper), text, name};
  const std::vector<pdf::Page> pages =
      pdf::pages_of(boxes_of_report(report, {&text, sheet.width_pt(), {}}), sheet.height_pt());
  pdf::PdfUpdate update(drawn(report, sheet, pages));
  update.extend(update.catalog(), "/Lang (en) /ViewerPreferences << /DisplayDocTitle true >>");
  return std::move(update).finished();
}

}  // namespace rva
