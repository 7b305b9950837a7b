// What a detection found, in the same shape whatever the method.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <variant>
#include <vector>

#include "detect/comparison.hpp"
#include "detect/regions.hpp"
#include "geometry/intrinsics.hpp"
#include "geometry/transform.hpp"

namespace rva {

enum class ChangeKind {
  added,       ///< nearer than before; or its depth went missing, as behind glass and on bare metal
  removed,     ///< farther than before; or depth appeared where there was none
  appearance,  ///< brighter or darker than before; depth cannot tell
};
[[nodiscard]] std::string_view name_of(ChangeKind kind);
[[nodiscard]] std::optional<ChangeKind> change_kind_from_name(std::string_view name);

/// What speaks for a finding.
struct Evidence {
  bool depth = true;
  bool appearance = false;  ///< infrared or colour images look different there

  bool operator==(const Evidence&) const = default;
};

/// One change, of one kind throughout. Pixels are of the final depth image, positions in the final depth
/// camera's frame. What a method cannot give is empty.
struct Finding {
  int id = 0;  ///< from 1, most suspicious first
  ChangeKind kind = ChangeKind::added;
  Box box;
  std::vector<std::uint32_t> pixels;  ///< changed pixels, by position in the rows laid end to end
  Eigen::Vector2d centroid{0, 0};     ///< mean of the pixels
  std::optional<Eigen::Vector3d>
      position_m;  ///< the centroid at the region's median depth, before where there is none after
  std::optional<std::array<double, 2>> size_mm;  ///< the box's width and height at that depth
  /// Median change of depth over the region, along z: above 0 for `added`, below for `removed`. Empty where
  /// less than half of the region has a depth both before and after.
  std::optional<double> height_mm;
  std::optional<double> score;  ///< larger is more suspicious; comparable within a method
  std::optional<double> p_value;
  /// The id of the removed finding that an added one has about the size of (moved_things.hpp).
  std::optional<int> moved_from;
  Evidence evidence;
};

/// Milliseconds that each stage took.
struct Runtime {
  double load_ms = 0.0;
  double statistics_ms = 0.0;
  double detect_ms = 0.0;
  double regions_ms = 0.0;
  double total_ms = 0.0;
};

struct Findings {
  std::string method;
  std::vector<std::pair<std::string, std::variant<int, double>>>
      parameters;  ///< every option that had a say, by its name in JSON
  std::size_t initial_frames = 0;
  std::size_t final_frames = 0;
  Transform final_from_initial = Transform::Identity();
  Coverage coverage;
  Runtime runtime;
  /// The share of the final image in which infrared or colour images were compared; empty where none were.
  std::optional<double> appearance_judged{};
  std::vector<Finding> findings;  ///< most suspicious first, those of appearance alone after all others
};

/// Position and size of a finding, from its centroid, its box and the median of depths; nothing where there
/// are none.
/// @param depths_m of its pixels; reordered
void place(const Intrinsics& camera, std::vector<float>& depths_m, Finding& finding);

/// The regions of a comparison, measured, the most suspicious first. Pixels that came nearer and pixels that
/// went farther are never of one region, however close they lie.
///
/// Where evidence is rarity, the score is that of the rarest pixel, and the p-value the probability that an
/// inspection without any change shows something as rare. Elsewhere the score is the mean evidence of the
/// region's pixels times the root of their number: what a sum of independent evidence comes to in deviations
/// of one pixel. Neighbours are not independent, so it ranks, and says nothing about probability.
[[nodiscard]] std::vector<Finding> find_findings(const Comparison& comparison, const RegionOptions& options,
                                                 const Intrinsics& camera);

/// `detections.json` (docs/detection.md), ending in a line feed.
[[nodiscard]] std::string to_json(const Findings& findings);

}  // namespace rva
