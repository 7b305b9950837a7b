#include "inspect/inspection.hpp"

#include <algorithm>
#include <array>

namespace rva {
namespace {

template <typename Value>
struct Named {
  Value value;
  std::string_view name;
};

constexpr std::array sides{Named{Side::initial, "initial"}, Named{Side::final, "final"}};
constexpr std::array verdicts{
    Named{Verdict::debris_removed, "debris-removed"}, Named{Verdict::installed_work, "installed-work"},
    Named{Verdict::false_alarm, "false-alarm"}, Named{Verdict::second_look, "second-look"}};
constexpr std::array stages{Named{Stage::baseline, "baseline"}, Named{Stage::work, "work"},
                            Named{Stage::review, "review"}, Named{Stage::done, "done"}};

template <typename Names, typename Value>
std::string_view name_in(const Names& names, Value value) {
  return std::ranges::find(names, value, &Named<Value>::value)->name;
}

template <typename Value, std::size_t size>
std::optional<Value> value_in(const std::array<Named<Value>, size>& names, std::string_view name) {
  const auto* const found = std::ranges::find(names, name, &Named<Value>::name);
  return found == names.end() ? std::nullopt : std::optional(found->value);
}

}  // namespace

bool is_settled(const ReviewedFinding& finding) {
  return finding.decision && finding.decision->verdict != Verdict::second_look;
}

std::string_view name_of(Side side) { return name_in(sides, side); }
std::optional<Side> side_from_name(std::string_view name) { return value_in(sides, name); }

std::string_view name_of(Verdict verdict) { return name_in(verdicts, verdict); }
std::optional<Verdict> verdict_from_name(std::string_view name) { return value_in(verdicts, name); }

std::string_view name_of(Stage stage) { return name_in(stages, stage); }

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
