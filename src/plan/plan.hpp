// Planned work: what the work order states will change, so that true changes are distinguished from debris.
#pragma once

#include <Eigen/Core>
#include <filesystem>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "core/enum_names.hpp"
#include "detect/findings/findings.hpp"
#include "geometry/intrinsics.hpp"

namespace rva {

/// What the points of a plan refer to: the first initial depth image, or the frame of its camera.
enum class PlanCoordinates { pixels, metres };
/// The names that plan files use.
template <>
inline constexpr auto enum_names<PlanCoordinates> = std::to_array<EnumName<PlanCoordinates>>({
    {PlanCoordinates::pixels, "pixels"},
    {PlanCoordinates::metres, "metres"},
});

/// A point of a plan.
struct PlanPoint {
  Eigen::Vector2d at{0, 0};  ///< pixels; in metres: x and y at a depth of 1 m, along the ray of the point
  double depth_m = 0.0;      ///< in metres: along z, above 0; in pixels: 0, which is not known

  bool operator==(const PlanPoint&) const = default;
};

/// Limits of a quantity in millimetres, both included.
struct RangeMm {
  double low = 0.0;   ///< least value, above 0
  double high = 0.0;  ///< largest value, at least `low`

  bool operator==(const RangeMm&) const = default;
};

/// Parts of one kind in one area: an entry of a plan.
struct PlannedItem {
  std::string name;                     ///< unique in its plan, such as "collars in row 3"
  ChangeKind kind = ChangeKind::added;  ///< installed, taken away, or seen in the images alone
  int count = 1;                        ///< number of parts, above 0
  RangeMm height_mm;               ///< of the parts above what they are on; of `appearance`, it has no effect
  std::optional<RangeMm> size_mm;  ///< of their largest extent; empty: any
  std::vector<std::vector<PlanPoint>> areas;  ///< polygons in which their centres lie; may be empty
  std::vector<PlanPoint> places;  ///< centres of the parts, `count` of them; empty where only areas are known
  double tolerance_mm = 10.0;     ///< how far from its place a part may be, above 0

  bool operator==(const PlannedItem&) const = default;
};

/// What the work order states will change.
struct Plan {
  PlanCoordinates coordinates = PlanCoordinates::pixels;  ///< of all points
  std::vector<PlannedItem> items;                         ///< in the order of the file, at least one

  bool operator==(const Plan&) const = default;
};

/// Parses the text of a plan (docs/planned-work.md).
/// @param source name of the text in error messages
/// @throws Error naming the line and the field: not YAML, a missing or unknown field, an unknown kind, a
/// value
///         out of range, a polygon that crosses itself; areas of two items of one kind that overlap, places
///         that are nearer to each other than their tolerance, a count that differs from the number of places
[[nodiscard]] Plan parse_plan(const std::string& text, const std::string& source);

/// The content of a plan file, which parse_plan() reads back.
[[nodiscard]] nlohmann::ordered_json json_of(const Plan& plan);

/// Reads a plan file. @throws Error as parse_plan(); when the file cannot be read
[[nodiscard]] Plan read_plan(const std::filesystem::path& file);

}  // namespace rva
