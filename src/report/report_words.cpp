#include "report/report_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "classify/finding_classes.hpp"
#include "core/date_time.hpp"

namespace rva {
namespace {

std::string millimetres(double value) {
  constexpr double coarse_from_mm = 10.0;
  return fmt::format("{:.{}f} mm", value, std::abs(value) < coarse_from_mm ? 1 : 0);
}

std::string kind_text(ChangeKind kind) {
  switch (kind) {
    case ChangeKind::added:
      return "Added";
    case ChangeKind::removed:
      return "Removed";
    case ChangeKind::appearance:
      break;
  }
  return "Looks different";
}

// Above the surface around it where that is known, or else by how much the surface is nearer or farther.
void add_height(const Finding& finding, std::vector<std::string>& parts) {
  const std::string_view before = finding.kind == ChangeKind::removed ? " before" : "";
  if (finding.top_above_surroundings_mm)
    parts.push_back(fmt::format("{}{} high{}", finding.top_is_least ? "at least " : "",
                                millimetres(*finding.top_above_surroundings_mm), before));
  else if (finding.above_surroundings_mm)
    parts.push_back(
        fmt::format("{} above its surroundings{}", millimetres(*finding.above_surroundings_mm), before));
  if (finding.background_jump)
    parts.emplace_back("at an edge, where the background jumps");
  else if (finding.height_mm && !finding.above_surroundings_mm)
    parts.push_back(fmt::format("surface {} {} than before", millimetres(std::abs(*finding.height_mm)),
                                *finding.height_mm > 0 ? "nearer" : "farther"));
}

}  // namespace

std::string time_text(const std::string& iso_8601) {
  constexpr std::size_t date = 10;
  constexpr std::size_t minutes = 16;
  if (!ns_since_1970(iso_8601)) return iso_8601;
  return iso_8601.substr(0, date) + " " + iso_8601.substr(date + 1, minutes - date - 1) + " UTC";
}

std::string percent_text(double share) {
  constexpr double rounding = 1e-9;  // of a share that is a whole number of percents
  return fmt::format("{:.0f} %", std::floor(100.0 * share + rounding));
}

std::string counted(std::size_t count, std::string_view singular, std::string_view plural) {
  return fmt::format("{} {}", count, count == 1 ? singular : plural);
}

std::string listed(const std::vector<std::string>& parts) {
  std::string list;
  for (std::size_t k = 0; k < parts.size(); ++k)
    list += (k == 0 ? "" : k + 1 == parts.size() ? " and " : ", ") + parts[k];
  return list;
}

std::string_view verdict_text(Verdict verdict) {
  switch (verdict) {
    case Verdict::debris:
      return "Debris, still there";
    case Verdict::debris_removed:
      return "Debris, removed";
    case Verdict::debris_unreachable:
      return "Debris, cannot be reached";
    case Verdict::installed_work:
      return "Installed work";
    case Verdict::false_alarm:
      return "False alarm";
    case Verdict::second_look:
      return "Needs a second look";
    case Verdict::undecided:
      break;
  }
  return "To be decided";
}

std::string counts_text(const VerdictCounts& counts) {
  const std::array<std::pair<std::size_t, std::string_view>, 6> named{
      {{counts.removed, "debris removed"},
       {counts.debris, "debris left"},
       {counts.unreachable, "debris out of reach"},
       {counts.installed, "installed work"},
       {counts.false_alarms, "false alarm"},
       {counts.undecided, "undecided"}}};
  std::string text;
  for (const auto& [count, name] : named) {
    if (count == 0) continue;
    const bool is_plural = name == "false alarm" && count > 1;
    text += fmt::format("{}{} {}{}", text.empty() ? "" : ", ", count, name, is_plural ? "s" : "");
  }
  return text.empty() ? "nothing found" : text;
}

std::string change_text(const ReviewedFinding& finding) {
  std::string kind = kind_text(finding.finding.kind);
  switch (finding.planned.value_or(PlannedState::unplanned)) {
    case PlannedState::missing:
      return "Missing: " + finding.planned_item;
    case PlannedState::surplus:
      return fmt::format("{}, beyond the planned {}", kind, finding.planned_item);
    case PlannedState::planned:
      return fmt::format("{}, planned: {}", kind, finding.planned_item);
    case PlannedState::unplanned:
      break;
  }
  return kind;
}

std::string measures_text(const Finding& finding) {
  std::vector<std::string> parts;
  if (finding.size_mm)
    parts.push_back(
        fmt::format("{} × {}", millimetres((*finding.size_mm)[0]), millimetres((*finding.size_mm)[1])));
  if (finding.position_m) parts.push_back(fmt::format("{:.2f} m away", finding.position_m->z()));
  if (finding.kind == ChangeKind::appearance)
    parts.emplace_back("brighter or darker than before; not visible in depth");
  add_height(finding, parts);
  return fmt::format("{}", fmt::join(parts, ", "));
}

std::string class_text(const ReviewedFinding& finding) {
  if (finding.likely_class.empty() || finding.likely_class == unknown_class || !finding.class_probability)
    return {};
  return fmt::format("may be: {} ({})", finding.likely_class, percent_text(*finding.class_probability));
}

std::string findable_text(const std::vector<FindableShare>& shares, bool is_one_view) {
  if (shares.empty()) return {};
  const std::string first = percent_text(shares.front().share);
  std::string text = fmt::format("objects of {:g} mm would have been found in {}", shares.front().size_mm,
                                 is_one_view ? first + " of it" : "at least " + first + " of each view");
  for (auto other = shares.begin() + 1; other != shares.end(); ++other)
    text += fmt::format(", of {:g} mm in {}", other->size_mm, percent_text(other->share));
  return text;
}

std::vector<FindableShare> least_findable(const std::vector<ComparedView>& views) {
  if (views.empty()) return {};
  std::vector<FindableShare> least = views.front().findable;
  for (FindableShare& of_size : least)
    for (const ComparedView& view : views) {
      const auto same = std::ranges::find(view.findable, of_size.size_mm, &FindableShare::size_mm);
      of_size.share = std::min(of_size.share, same == view.findable.end() ? 0.0 : same->share);
    }
  return least;
}

}  // namespace rva
