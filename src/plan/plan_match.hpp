// Findings assigned to planned work: what was planned and found, what is missing, and what was not planned.
#pragma once

#include <Eigen/Core>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/enum_names.hpp"
#include "core/options.hpp"
#include "detect/detect.hpp"
#include "plan/baseline_view.hpp"
#include "plan/plan.hpp"

namespace rva {

/// Options of match_plan().
struct PlanOptions {
  double height_error_mm = 16.0;  ///< the 90 % error of measured heights (docs/detection.md)
  double inspected = 0.9;         ///< share of an area that must have been inspected, 0 to 1

  static void describe(auto&& self, auto&& visit) {
    visit(self.height_error_mm,
          OptionField{"height-error", "mm", 0, 1000,
                      "with a plan: by how much a measured height may be wrong, or by the level of detection "
                      "there where that is larger"});
    visit(
        self.inspected,
        OptionField{"inspected", "", 0, 1,
                    "with a plan: the share of an area that must have been inspected before parts that were "
                    "not found there are missing"});
  }
};

/// What a finding is according to a plan.
enum class PlannedState {
  unplanned,  ///< it, or a piece of it, matches nothing in the plan
  surplus,    ///< it would match, but there are more than planned, or it is larger than a planned part
  planned,    ///< all of it is planned
  missing,    ///< no finding of a detector, but a planned part that was not found (inspect/)
};
/// The names that files use.
template <>
inline constexpr auto enum_names<PlannedState> = std::to_array<EnumName<PlannedState>>({
    {PlannedState::unplanned, "unplanned"},
    {PlannedState::surplus, "surplus"},
    {PlannedState::planned, "planned"},
    {PlannedState::missing, "missing"},
});

/// A planned part that was not found.
struct AbsentPart {
  std::optional<int> place;              ///< number in the item's places, from 1; empty without places
  std::optional<Eigen::Vector2d> pixel;  ///< of the place, in the baseline's depth image
};

/// An item of the plan and what was found of it.
struct PlannedGroup {
  std::string name;                       ///< of the item
  ChangeKind kind = ChangeKind::added;    ///< of the item
  int planned = 0;                        ///< number of parts
  int found = 0;                          ///< number of them that were found, at most `planned`
  std::vector<AbsentPart> missing;        ///< not found where the view was inspected
  std::vector<AbsentPart> not_inspected;  ///< not found, but where they could not have been
  std::vector<int> findings;              ///< ids of the findings that are entirely planned, ascending
};

/// A piece of a finding that needs a look of its own.
struct LoosePiece {
  int finding = 0;                  ///< id
  Box box;                          ///< in the final depth image
  std::size_t area_px = 0;          ///< number of its pixels
  std::optional<double> height_mm;  ///< as of Finding, of the piece
  std::optional<std::string> item;  ///< that it is a surplus of
};

/// A finding with its state.
struct PlannedFinding {
  int id = 0;                                    ///< of the finding
  PlannedState state = PlannedState::unplanned;  ///< exactly one
  std::optional<std::string> item;               ///< that it belongs to; empty if it is unplanned
};

/// Findings compared with a plan.
struct PlanMatch {
  std::vector<PlannedGroup> groups;      ///< one for each item, in the order of the plan
  std::vector<LoosePiece> unplanned;     ///< in the order of the findings
  std::vector<LoosePiece> surplus;       ///< in the order of the findings
  std::vector<PlannedFinding> findings;  ///< all: unplanned ones first, then surplus ones, then planned ones
};

/// Assigns the pieces of findings (pieces.hpp) to planned parts so that as many parts as possible are found,
/// each piece at the part that it is nearest to, over all parts together (docs/planned-work.md).
///
/// - A piece may be a part if its centre is in an area of the item, or within the tolerance of a place or
/// upon
///   it; if its height is in the item's range within its uncertainty, with the sign of the kind; and if it
///   is neither larger than the item allows nor, away from all places, less than half as large. A piece of
///   appearance alone has no height and may be of any kind; at a place, this also holds for a piece whose
///   depth is not measured on both sides, or too small to be resolved.
/// - A piece upon several places that it does not stand out of counts as several parts.
/// - A piece without a part belongs to an assigned one at whose place it is, if its centre is within the part
///   or it is less than half as large; to one right beside it that is more than twice as large; and to one a
///   window away, or of the same finding, that is more than four times as large.
///
/// The result depends on neither the order of the findings nor on findings elsewhere.
/// @throws UsageError for options out of range
[[nodiscard]] PlanMatch match_plan(const Plan& plan, const Detection& detection,
                                   const ComparedCameras& cameras, const PlanOptions& options);

/// The content of `plan.json` (docs/planned-work.md).
[[nodiscard]] nlohmann::ordered_json json_of(const PlanMatch& match);

/// Adds the groups and the state of each finding to the content of `detections.json`.
void add_plan(const PlanMatch& match, nlohmann::ordered_json& detections);

}  // namespace rva
