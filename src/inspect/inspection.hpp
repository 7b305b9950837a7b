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

/// One side of an inspection, complete: a capture of every view.
struct TakenSide {
  std::string taken_at;  ///< ISO 8601, when the last view was
  std::string person;    ///< who took it
  std::string base;      ///< where the robot's foot stood
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
  std::optional<TakenSide> initial;
  std::optional<TakenSide> final;
  std::string compared_at;  ///< ISO 8601; empty before
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

}  // namespace rva
