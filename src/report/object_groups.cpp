#include "report/object_groups.hpp"

#include <algorithm>

namespace rva {

std::vector<ObjectGroup> object_groups(const std::vector<ReviewedFinding>& findings) {
  std::vector<ObjectGroup> groups;
  for (const ReviewedFinding& finding : findings) {
    const auto same = [&](const ObjectGroup& group) { return group.lead->same_as == finding.same_as; };
    if (const auto group = std::ranges::find_if(groups, same); group != groups.end())
      group->all.push_back(&finding);
    else
      groups.push_back({static_cast<int>(groups.size()) + 1, &finding, {&finding}});
  }
  return groups;
}

const ReviewedFinding& best_seen(const ObjectGroup& group) {
  const auto clear_px = [](const ReviewedFinding& finding) { return finding.clear_px.value_or(0); };
  const ReviewedFinding* best = group.lead;
  for (const ReviewedFinding* const finding : group.all)
    if (clear_px(*finding) > clear_px(*best)) best = finding;
  return *best;
}

void VerdictCounts::count(const std::optional<Decision>& decision) {
  switch (decision ? decision->verdict : Verdict::undecided) {
    case Verdict::debris:
      ++debris;
      break;
    case Verdict::debris_removed:
      ++removed;
      break;
    case Verdict::debris_unreachable:
      ++unreachable;
      break;
    case Verdict::installed_work:
      ++installed;
      break;
    case Verdict::false_alarm:
      ++false_alarms;
      break;
    case Verdict::second_look:
    case Verdict::undecided:
      ++undecided;
      break;
  }
}

VerdictCounts verdicts_of(const std::vector<ReviewedFinding>& findings) {
  VerdictCounts counts;
  for (const ObjectGroup& group : object_groups(findings)) counts.count(group.lead->decision);
  return counts;
}

}  // namespace rva
