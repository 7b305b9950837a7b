// Findings as people see them: with their number in the inspection and the decision on them.
#pragma once

#include <Eigen/Core>
#include <array>
#include <optional>
#include <string>

#include "core/enum_names.hpp"
#include "detect/findings/findings.hpp"
#include "plan/plan_match.hpp"

namespace rva {

/// The verdict of a person who reviewed a finding.
enum class Verdict {
  debris,
  debris_removed,
  debris_unreachable,
  installed_work,
  false_alarm,
  second_look,
  undecided  ///< withdraws the earlier decision; recorded, but a finding that is read has no decision then
};
template <>
inline constexpr auto enum_names<Verdict> = std::to_array<EnumName<Verdict>>({
    {Verdict::debris, "debris"},  ///< which is still there
    {Verdict::debris_removed, "debris-removed"},
    {Verdict::debris_unreachable, "debris-unreachable"},
    {Verdict::installed_work, "installed-work"},
    {Verdict::false_alarm, "false-alarm"},
    {Verdict::second_look, "second-look"},
    {Verdict::undecided, "undecided"},
});

/// A person's decision on a finding.
struct Decision {
  Verdict verdict = Verdict::second_look;
  std::string note;
  std::string person;
  std::string decided_at;  ///< ISO 8601
  /// The last complete round of the final side at that time; 0 if there was none, or it is not known.
  int round = 0;
  /// What the object is, as the person named it: a label of the classifier or any other text; empty where the
  /// person did not.
  std::string object{};
};

/// Whether nothing remains to be done about a finding: there is a decision, which neither asks for a second
/// look nor states that debris is still there.
[[nodiscard]] bool is_settled(const std::optional<Decision>& decision);

/// A finding of one view, with its decision.
struct ReviewedFinding {
  int number = 0;  ///< from 1 within its comparison, most suspicious first
  int view = 0;    ///< index into Inspection::views
  /// Number of the most suspicious finding of the same object among all views, which may be this one.
  int same_as = 0;
  Finding finding;                             ///< in the coordinates of its view; without its pixels
  std::optional<Eigen::Vector3d> in_foot_m{};  ///< position in the frame of the robot's foot, as in the map
  std::optional<Decision> decision{};          ///< the latest one
  /// In how many of its pixels its view shows it clearly: with depth, within the colour imager's view where
  /// there is one; 0 if it reaches the border of the image. Empty in comparisons of earlier versions.
  std::optional<int> clear_px{};
  /// For an added finding: number of the removed finding in the same view that has about the same size.
  std::optional<int> moved_from{};
  /// What it is according to the plan of its view; empty without a plan. A missing part is no finding of the
  /// detector: it has a box, and a position where that is known, and no evidence.
  std::optional<PlannedState> planned{};
  std::string planned_item{};  ///< the item of the plan that it belongs to; empty if it is unplanned
  /// What the classifier calls it: a label, or unknown_class; empty where the classifier was not shown it, as
  /// in comparisons of earlier versions.
  std::string likely_class{};
  std::optional<double> class_probability{};  ///< of the most probable label, with likely_class
};

/// A finding that a person marked in a picture. It stays with its inspection through later rounds.
struct MarkedFinding {
  int number = 0;             ///< from 1 within its inspection
  std::optional<int> view{};  ///< index into Inspection::views; empty if it was marked in the live picture
  int comparison = 0;         ///< whose pictures were shown; 0 for the live picture
  int round = 0;              ///< the last complete round of the final side at that time; 0 if there was none
  std::string picture{};      ///< the file it was marked in, relative to the inspection's folder
  Box box{};                  ///< in pixels of that picture
  /// The surface in the middle of the box, in the depth camera's frame; empty if it was not measured.
  std::optional<Eigen::Vector3d> position_m{};
  std::optional<Eigen::Vector3d> in_foot_m{};      ///< the same in the frame of the robot's foot
  std::optional<std::array<double, 2>> size_mm{};  ///< the box's width and height at that distance
  std::string note{};
  std::string person{};
  std::string marked_at{};             ///< ISO 8601
  std::optional<Decision> decision{};  ///< the latest one
};

/// A decision on one of the findings that are decided together.
struct FindingDecision {
  int number = 0;       ///< of a finding of the comparison, or of a marked finding
  bool marked = false;  ///< whether it is a marked finding
  Decision decision;
};

}  // namespace rva
