#include "report/object_groups.hpp"

#include <map>

namespace rva {

std::vector<ObjectGroup> object_groups(const std::vector<ReviewedFinding>& findings) {
  std::vector<ObjectGroup> groups;
  std::map<int, std::size_t> group_of;  // by ReviewedFinding::same_as
  for (const ReviewedFinding& finding : findings) {
    const auto [known, is_new] = group_of.try_emplace(finding.same_as, groups.size());
    if (is_new) groups.push_back({static_cast<int>(groups.size()) + 1, &finding, {}});
    groups[known->second].all.push_back(&finding);
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

VerdictCounts verdicts_of(const std::vector<ReviewedFinding>& findings) {
  VerdictCounts counts;
  for (const ObjectGroup& group : object_groups(findings)) counts.count(group.lead->decision);
  return counts;
}

}  // namespace rva
