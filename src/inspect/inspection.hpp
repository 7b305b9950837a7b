// The record of one inspection of one bay.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/enum_names.hpp"
#include "detect/findings/findings.hpp"
#include "detect/regions/ignored_regions.hpp"
#include "geometry/pan_tilt.hpp"

namespace rva {

/// What the operator enters when an inspection begins. Free text; `person` must be a legible name
/// (is_legible_name()).
struct InspectionOrder {
  std::string aircraft;
  std::string zone;
  std::string work_order;
  std::string person;
};

/// A side of an inspection.
enum class Side {
  initial,  ///< before the work: the baseline
  final,    ///< after the work
};
template <>
inline constexpr auto enum_names<Side> = std::to_array<EnumName<Side>>({
    {Side::initial, "initial"},
    {Side::final, "final"},
});

/// One round of captures of a side. Captures are never replaced: taking a side again adds another round.
struct BegunSide {
  int round = 1;
  std::string person;  ///< name of the operator who takes it
  std::string base;    ///< identifies the position of the robot's foot (Pose::base)
};

/// A complete round of a side, with the captures of every view.
struct TakenSide {
  std::string taken_at;  ///< ISO 8601, time at which the last view was taken
  std::string person;    ///< name of the operator who took it
  std::string base;      ///< identifies the position of the robot's foot (Pose::base)
  int round = 1;
};

/// One comparison of the two sides.
struct RecordedComparison {
  int number = 0;           ///< from 1 within its inspection
  std::string compared_at;  ///< ISO 8601, for display only: the clock may stand still or be set back
  std::string folder;       ///< of its results, relative to the inspection's folder
};

/// The verdict of a person who reviewed a finding.
enum class Verdict { debris_removed, installed_work, false_alarm, second_look };
template <>
inline constexpr auto enum_names<Verdict> = std::to_array<EnumName<Verdict>>({
    {Verdict::debris_removed, "debris-removed"},
    {Verdict::installed_work, "installed-work"},
    {Verdict::false_alarm, "false-alarm"},
    {Verdict::second_look, "second-look"},
});

/// A person's decision on a finding.
struct Decision {
  Verdict verdict = Verdict::second_look;
  std::string note;
  std::string person;
  std::string decided_at;  ///< ISO 8601
};

/// A finding of one view, with its decision.
struct ReviewedFinding {
  int number = 0;  ///< from 1 within its inspection, most suspicious first
  int view = 0;    ///< index into Inspection::views
  /// Number of the most suspicious finding of the same object among all views, which may be this one.
  int same_as = 0;
  Finding finding;                             ///< in the coordinates of its view; without its pixels
  std::optional<Eigen::Vector3d> in_foot_m{};  ///< position in the frame of the robot's foot, as in the map
  std::optional<Decision> decision{};          ///< the latest one
  /// For an added finding: number of the removed finding in the same view that has about the same size.
  std::optional<int> moved_from{};
};

/// The result of the comparison of one view, without its findings.
struct ComparedView {
  int view = 0;  ///< index into Inspection::views
  std::string method;
  Coverage coverage;
  double judged = 0.0;                ///< share of the depth image where a change could have been found
  std::vector<std::string> warnings;  ///< sentences for the user
};

/// Views are angles of the robot's joints. Without a robot there is one view, whose angles have no meaning.
struct Inspection {
  std::int64_t id = 0;  ///< from 1
  InspectionOrder order;
  std::string created_at;  ///< ISO 8601
  std::vector<PanTilt> views;
  int dither = 1;  ///< number of captures of each view, a few servo steps apart
  /// Regions left out of the comparison, by index of the view, in pixels of its first initial depth image.
  std::map<int, std::vector<Polygon>> ignored;
  std::optional<TakenSide> initial;  ///< the last complete round
  std::optional<TakenSide> final;    ///< the last complete round
  std::map<Side, BegunSide> begun;   ///< rounds in progress, later than the complete ones
  /// The current comparison: empty before the first one, and after a side was taken or regions were changed
  /// since.
  std::optional<RecordedComparison> comparison;
  std::vector<std::string> unfinished_comparisons{};  ///< folders of comparisons begun but not recorded
  int comparisons = 0;  ///< the highest number so far, outdated and unfinished comparisons included
  std::vector<ComparedView> compared;
  std::vector<ReviewedFinding> findings;
};

/// Whether there is a decision other than Verdict::second_look.
[[nodiscard]] bool is_settled(const ReviewedFinding& finding);

/// The smallest ComparedView::judged of all views.
/// @return empty if a view was not compared
[[nodiscard]] std::optional<double> least_judged(const Inspection& inspection);

/// The next step of an inspection. It is never in review or done unless all of its views were compared.
enum class Stage { baseline, work, review, done };
template <>
inline constexpr auto enum_names<Stage> = std::to_array<EnumName<Stage>>({
    {Stage::baseline, "baseline"},
    {Stage::work, "work"},
    {Stage::review, "review"},
    {Stage::done, "done"},
});
[[nodiscard]] Stage stage_of(const Inspection& inspection);

/// An inspection as an entry of the list of inspections.
struct InspectionSummary {
  std::int64_t id = 0;
  InspectionOrder order;
  std::string created_at;  ///< ISO 8601
  Stage stage = Stage::baseline;
  std::size_t findings = 0;   ///< number of findings of the current comparison
  std::size_t undecided = 0;  ///< number of those that are not settled (is_settled())
  std::optional<TakenSide> initial;
  std::optional<TakenSide> final;
  std::optional<RecordedComparison> comparison;
};
[[nodiscard]] InspectionSummary summary_of(const Inspection& inspection);

}  // namespace rva
