#include "inspect/inspection.hpp"

#include <algorithm>

namespace rva {

bool is_settled(const ReviewedFinding& finding) {
  return finding.decision && finding.decision->verdict != Verdict::second_look;
}

std::optional<double> least_judged(const Inspection& inspection) {
  if (inspection.compared.empty() || inspection.compared.size() != inspection.views.size())
    return std::nullopt;
  return std::ranges::min(inspection.compared, {}, &ComparedView::judged).judged;
}

Stage stage_of(const Inspection& inspection) {
  if (!inspection.initial) return Stage::baseline;
  if (!inspection.comparison || !least_judged(inspection)) return Stage::work;
  const bool settled = std::ranges::all_of(inspection.findings, is_settled);
  return settled ? Stage::done : Stage::review;
}

InspectionSummary summary_of(const Inspection& inspection) {
  const auto settled = std::ranges::count_if(inspection.findings, is_settled);
  return {.id = inspection.id,
          .order = inspection.order,
          .created_at = inspection.created_at,
          .stage = stage_of(inspection),
          .findings = inspection.findings.size(),
          .undecided = inspection.findings.size() - static_cast<std::size_t>(settled),
          .initial = inspection.initial,
          .final = inspection.final,
          .comparison = inspection.comparison};
}

}  // namespace rva
