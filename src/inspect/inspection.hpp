// One inspection of one bay: what is kept of it.
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "detect/findings.hpp"
#include "detect/ignored_regions.hpp"
#include "geometry/pan_tilt.hpp"

namespace rva {

/// What a person says of an inspection when it begins. Any text; the person must not be empty.
struct InspectionOrder {
  std::string aircraft;
  std::string zone;
  std::string work_order;
  std::string person;
};

enum class Side {
  initial,  ///< before the work: the baseline
  final,    ///< after it
};
[[nodiscard]] std::string_view name_of(Side side);
[[nodiscard]] std::optional<Side> side_from_name(std::string_view name);

/// One round of captures of a side: nothing that was captured is replaced, so that a side that is taken again
/// is another round of it.
struct BegunSide {
  int round = 1;
  std::string person;  ///< who takes it
  std::string base;    ///< where the robot's foot stands
};

/// One round of a side, complete: a capture of every view.
struct TakenSide {
  std::string taken_at;  ///< ISO 8601, when the last view was
  std::string person;    ///< who took it
  std::string base;      ///< where the robot's foot stood
  int round = 1;
};

/// One comparison of the two sides.
struct RecordedComparison {
  int number = 0;           ///< from 1 within its inspection
  std::string compared_at;  ///< ISO 8601, for people: a clock may stand or step back
  std::string folder;       ///< of its results, within the inspection's
};

/// What a person says of a finding who has looked at it.
enum class Verdict { debris_removed, installed_work, false_alarm, second_look };
[[nodiscard]] std::string_view name_of(Verdict verdict);
[[nodiscard]] std::optional<Verdict> verdict_from_name(std::string_view name);

struct Decision {
  Verdict verdict = Verdict::second_look;
  std::string note;
  std::string person;
  std::string decided_at;  ///< ISO 8601
};

/// A changed place of one view.
struct ReviewedFinding {
  int number = 0;  ///< from 1 within its inspection, most suspicious first
  int view = 0;    ///< by its position in the inspection's views
  /// Of the same thing, seen from several views: the number of the most suspicious of them, which may be its
  /// own.
  int same_as = 0;
  Finding finding;                             ///< in its view
  std::optional<Eigen::Vector3d> in_foot_m{};  ///< in the frame of the robot's foot, which the map has
  std::optional<Decision> decision{};          ///< the last one
  /// The number of the removed finding, in the same view, that an added one has about the size of.
  std::optional<int> moved_from{};
};

/// What the comparison of one view said besides its findings.
struct ComparedView {
  int view = 0;
  std::string method;
  Coverage coverage;
  double judged = 0.0;                ///< share of the depth image where a change could have been found
  std::vector<std::string> warnings;  ///< for a person
};

/// Views are angles of the robot's joints; where there is no robot there is one view, whose angles mean
/// nothing.
struct Inspection {
  std::int64_t id = 0;  ///< from 1
  InspectionOrder order;
  std::string created_at;  ///< ISO 8601
  std::vector<PanTilt> views;
  int dither = 1;  ///< captures of each view, a few servo steps apart
  /// By view: what is left out of the comparison, in pixels of its first initial depth image.
  std::map<int, std::vector<Polygon>> ignored;
  std::optional<TakenSide> initial;  ///< the last round that is complete
  std::optional<TakenSide> final;
  std::map<Side, BegunSide> begun;  ///< a later round that is under way
  std::optional<RecordedComparison>
      comparison;  ///< that holds; empty before, and when a side was taken since
  std::vector<std::string> unfinished_comparisons{};  ///< folders of those that were begun, not recorded
  int comparisons = 0;                                ///< made so far, those that hold no more included
  std::vector<ComparedView> compared;
  std::vector<ReviewedFinding> findings;
};

/// Somebody has decided, and not for a second look.
[[nodiscard]] bool is_settled(const ReviewedFinding& finding);

/// The share of all views where a change could have been found, at worst.
/// @return empty where a view was not compared
[[nodiscard]] std::optional<double> least_judged(const Inspection& inspection);

/// What is to be done next. Nothing is done that was not compared in all its views.
enum class Stage { baseline, work, review, done };
[[nodiscard]] std::string_view name_of(Stage stage);
[[nodiscard]] Stage stage_of(const Inspection& inspection);

/// What a list of inspections shows of one.
struct InspectionSummary {
  std::int64_t id = 0;
  InspectionOrder order;
  std::string created_at;  ///< ISO 8601
  Stage stage = Stage::baseline;
  std::size_t findings = 0;   ///< of the comparison that holds
  std::size_t undecided = 0;  ///< of them
  std::optional<TakenSide> initial;
  std::optional<TakenSide> final;
  std::optional<RecordedComparison> comparison;
};
[[nodiscard]] InspectionSummary summary_of(const Inspection& inspection);

}  // namespace rva
