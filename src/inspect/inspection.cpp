#include "inspect/inspection.hpp"

#include <algorithm>

namespace rva {

bool is_settled(const std::optional<Decision>& decision) {
  return decision && decision->verdict != Verdict::second_look && decision->verdict != Verdict::debris;
}

std::size_t undecided(const Inspection& inspection) {
  const auto open = [](const auto& finding) { return !is_settled(finding.decision); };
  return static_cast<std::size_t>(std::ranges::count_if(inspection.findings, open) +
                                  std::ranges::count_if(inspection.marked, open));
}

std::optional<double> least_judged(const Inspection& inspection) {
  if (inspection.compared.empty() || inspection.compared.size() != inspection.views.size())
    return std::nullopt;
  return std::ranges::min(inspection.compared, {}, &ComparedView::judged).judged;
}

Stage stage_of(const Inspection& inspection) {
  if (inspection.closing) return Stage::done;
  if (!inspection.initial) return Stage::baseline;
  if (!inspection.comparison || !least_judged(inspection)) return Stage::work;
  return Stage::review;
}

InspectionSummary summary_of(const Inspection& inspection) {
  return {.id = inspection.id,
          .order = inspection.order,
          .created_at = inspection.created_at,
          .stage = stage_of(inspection),
          .findings = inspection.findings.size() + inspection.marked.size(),
          .undecided = undecided(inspection),
          .initial = inspection.initial,
          .final = inspection.final,
          .comparison = inspection.comparison,
          .closing = inspection.closing};
}

}  // namespace rva
