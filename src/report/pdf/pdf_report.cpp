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

std::string stated_time(const ReportDocument& report) {
  return ns_since_1970(report.last_action_at) ? report.last_action_at : "1970-01-01T00:00:00.000Z";
}

// Without a time, cairo would state the present one; some versions write it in a form that is none of PDF, so
// all of the metadata is replaced afterwards.
void state_time(cairo_surface_t* surface, const std::string& time) {
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_CREATE_DATE, time.c_str());
  cairo_pdf_surface_set_metadata(surface, CAIRO_PDF_METADATA_MOD_DATE, time.c_str());
}

std::string with_metadata(std::string file, const ReportDocument& report) {
  pdf::PdfUpdate update(std::move(file));
  const std::string time = pdf::time_string(stated_time(report));
  update.replace(
      update.info(),
      fmt::format("<< /Title {} /Subject {} /Creator {} /Producer {} /CreationDate {} /ModDate {} >>",
                  pdf::text_string(shown_text(report.title + " · inspection report")),
                  pdf::text_string(fmt::format("Inspection {}", report.inspection)),
                  pdf::text_string(program_text()),
                  pdf::text_string(fmt::format("cairo {}", cairo_version_string())), time, time));
  update.extend(update.catalog(), "/Lang (en) /ViewerPreferences << /DisplayDocTitle true >>");
  return std::move(update).finished();
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
  state_time(surface.get(), stated_time(report));
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
  return with_metadata(drawn(report, sheet, pages), report);
}

}  // namespace rva
