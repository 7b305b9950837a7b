// The record of one inspection of one bay.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/enum_names.hpp"
#include "detect/calibrated/level_of_detection.hpp"
#include "detect/regions/comparison.hpp"
#include "detect/regions/ignored_regions.hpp"
#include "geometry/pan_tilt.hpp"
#include "inspect/checkout.hpp"
#include "inspect/reviewed_finding.hpp"

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
  int final_round = 0;      ///< the round of the final side that was compared; 0 if it is not known
};

/// What a comparison found of one item of a view's plan.
struct PlannedWork {
  std::string name;                     ///< of the item
  ChangeKind kind = ChangeKind::added;  ///< of the item
  int planned = 0;                      ///< number of parts
  int found = 0;                        ///< number of them that were found
  int missing = 0;                      ///< number of those that would have been found, and were not
  int not_inspected = 0;                ///< number of the others

  bool operator==(const PlannedWork&) const = default;
};

/// The result of the comparison of one view, without its findings.
struct ComparedView {
  int view = 0;  ///< index into Inspection::views
  std::string method;
  Coverage coverage;
  double judged = 0.0;                ///< share of the depth image where a change could have been found
  std::vector<std::string> warnings;  ///< sentences for the user
  /// Shares of the depth image where objects of some sizes would have been found; empty if it is not known.
  std::vector<FindableShare> findable{};
  std::vector<PlannedWork> planned{};  ///< one for each item of the view's plan
};

/// One comparison with all that it showed, as it is kept after later ones.
struct ComparedRound {
  RecordedComparison comparison;
  std::optional<TakenSide> final;  ///< the round of the final side that was compared, if it is known
  std::vector<ComparedView> compared;
  std::vector<ReviewedFinding> findings;  ///< with their decisions
};

/// A live picture that a person kept with a note. It is no finding, and nothing is decided on it.
struct Snapshot {
  int number = 0;       ///< from 1 within its inspection
  std::string picture;  ///< its file, relative to the inspection's folder
  std::string note;
  std::string person;
  std::string taken_at;  ///< ISO 8601, when it was kept
};

/// A person's statement that an inspection is complete (require_closable()).
struct Closing {
  int comparison = 0;  ///< number of the comparison that the person reviewed
  std::string person;
  std::string note;
  std::string closed_at;  ///< ISO 8601
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
  std::map<int, Plan> planned{};     ///< what the work order states will change, by index of the view
  std::optional<TakenSide> initial;  ///< the last complete round
  std::optional<TakenSide> final;    ///< the last complete round
  std::map<Side, BegunSide> begun;   ///< rounds in progress, later than the complete ones
  /// The current comparison: empty before the first one, and after a side was taken, or regions or a plan
  /// were changed since.
  std::optional<RecordedComparison> comparison;
  std::vector<std::string> unfinished_comparisons{};  ///< folders of comparisons begun but not recorded
  int comparisons = 0;  ///< the highest number so far, outdated and unfinished comparisons included
  std::vector<ComparedView> compared;
  std::vector<ReviewedFinding> findings;  ///< of the current comparison
  std::vector<MarkedFinding> marked;      ///< by a person, in any round
  std::vector<Snapshot> snapshots{};      ///< in the order in which they were kept
  std::vector<CheckedOutItem> items{};    ///< the check-out list
  std::optional<Closing> closing;         ///< nothing can be changed afterwards
};

/// A complete round of captures.
struct CapturedRound {
  Side side = Side::initial;
  TakenSide taken;
};

/// A decision as it was made, also one that a later decision superseded.
struct RecordedDecision {
  int comparison = 0;  ///< number of the comparison that found the finding; 0 for a marked finding
  int finding = 0;     ///< number of the finding in its comparison, or of the marked finding
  Decision decision;
};

/// All that the records contain of an inspection, in one state.
struct InspectionHistory {
  Inspection inspection;
  std::vector<CapturedRound> captured;  ///< the initial side first, each in the order of its rounds
  std::vector<ComparedRound> rounds;    ///< every complete comparison, newest first
  std::vector<RecordedDecision>
      decisions;  ///< those on findings, then those on marked ones, as they were made
};

/// Number of findings, those marked by a person included, that are not settled (is_settled()).
[[nodiscard]] std::size_t undecided(const Inspection& inspection);

/// The smallest ComparedView::judged of all views.
/// @return empty if a view was not compared
[[nodiscard]] std::optional<double> least_judged(const Inspection& inspection);

/// The next step of an inspection. It is never in review unless all of its views were compared, and done only
/// once a person has closed it.
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
  std::size_t findings = 0;   ///< number of findings of the current comparison, and of those marked
  std::size_t undecided = 0;  ///< number of those that are not settled (is_settled())
  std::optional<TakenSide> initial;
  std::optional<TakenSide> final;
  std::optional<RecordedComparison> comparison;
  std::optional<Closing> closing;
};
[[nodiscard]] InspectionSummary summary_of(const Inspection& inspection);

/// Which inspections a list shows.
struct InspectionFilter {
  /// Words that each occur in the aircraft, zone, work order, person or number, in any case of ASCII letters.
  std::string text{};
  std::optional<Stage> stage{};
  std::string from{};       ///< created at this time (ISO 8601) or later; empty for any
  std::string until{};      ///< created before this time (ISO 8601); empty for any
  std::int64_t before = 0;  ///< with smaller ids only; 0 for all
  std::size_t most = 0;     ///< number of entries at most; 0 for all
};

}  // namespace rva
