#include <fmt/format.h>

#include <algorithm>
#include <string>
#include <vector>

#include "report/object_groups.hpp"
#include "report/or_reason.hpp"
#include "report/report_pictures.hpp"
#include "report/report_sections.hpp"
#include "report/report_words.hpp"

namespace rva {
namespace {

// "no depth after 8 %, no depth before 3 %, edges, and too noisy 2 %".
std::string why_not(const ComparedView& view) {
  const Coverage& coverage = view.coverage;
  std::vector<std::string> reasons;
  const auto add = [&](double share, std::string_view reason) {
    constexpr double visible = 0.005;
    if (share >= visible) reasons.push_back(fmt::format("{} {}", reason, percent_text(share)));
  };
  add(coverage.left_out.value_or(0.0), "left out as asked");
  add(coverage.invalid, "no depth after");
  add(coverage.unseen, "no depth before");
  add(coverage.beyond_clip.value_or(0.0), "beyond the range of the method");
  const double named = coverage.left_out.value_or(0.0) + coverage.invalid + coverage.unseen +
                       coverage.beyond_clip.value_or(0.0);
  add(1.0 - view.judged - named, "edges, and too noisy");
  return fmt::format("{}", fmt::join(reasons, ", "));
}

std::string share_of(const ComparedView& view, double size_mm) {
  const auto found = std::ranges::find(view.findable, size_mm, &FindableShare::size_mm);
  return found == view.findable.end() ? "–" : percent_text(found->share);
}

ReportTable table_of(const Inspection& inspection) {
  ReportTable table{.role = PartRole::coverage_table,
                    .head = {Content::text("View"), Content::text("Inspected")},
                    .rows = {}};
  for (const double size_mm : findable_sizes_mm)
    table.head.push_back(Content::text(fmt::format("{:g} mm found in", size_mm)));
  table.head.push_back(Content::text("Not inspected"));
  for (const ComparedView& view : inspection.compared) {
    std::vector<Content> row{Content::text(std::to_string(view.view + 1)),
                             Content::text(percent_text(view.judged))};
    for (const double size_mm : findable_sizes_mm) row.push_back(Content::text(share_of(view, size_mm)));
    row.push_back(Content::text(why_not(view)));
    table.rows.push_back(row);
  }
  return table;
}

Content warnings_of(const Inspection& inspection) {
  Content list;
  for (const ComparedView& view : inspection.compared)
    for (const std::string& warning : view.warnings)
      list +=
          Content::of(PartRole::warning, Content::text(fmt::format("View {}: {}", view.view + 1, warning)));
  return list.empty() ? Content() : Content::of(PartRole::warnings, list);
}

Content pictures_of(const InspectionHistory& history, const InspectionFolder& folder) {
  const Inspection& inspection = history.inspection;
  ComparisonPictures pictures(folder, *inspection.comparison);
  if (!pictures.exist()) return {};
  const std::vector<ObjectGroup> groups = object_groups(inspection.findings);
  Content figures;
  for (const ComparedView& view : inspection.compared)
    figures +=
        Content::of(PartRole::figure,
                    or_reason([&] { return pictures.view(view.view, groups); }) +
                        Content::of(PartRole::caption,
                                    Content::text(fmt::format("View {} after the work", view.view + 1))));
  // Small where there is nothing to point out, so that the report fits a page.
  const bool is_large = inspection.compared.size() < 3 && !inspection.findings.empty();
  return Content::of(is_large ? PartRole::two_figures : PartRole::three_figures, figures);
}

}  // namespace

Content coverage_section(const InspectionHistory& history, const InspectionFolder& folder) {
  const Inspection& inspection = history.inspection;
  if (!inspection.comparison || inspection.compared.empty()) return {};
  return Content::of(PartRole::heading, Content::text("What was inspected")) +
         content_of(table_of(inspection)) +
         Content::of(PartRole::legend,
                     Content::text("“5 mm found in”: where an object that depth shows 5 mm high and wide "
                                   "would be found in nine "
                                   "of ten inspections. Striped: not inspected.")) +
         warnings_of(inspection) + pictures_of(history, folder);
}

}  // namespace rva
