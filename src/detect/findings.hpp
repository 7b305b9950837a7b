// What a detection found, in the same shape whatever the method.
#pragma once

#include <Eigen/Core>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "detect/comparison.hpp"
#include "detect/regions.hpp"
#include "geometry/intrinsics.hpp"
#include "geometry/transform.hpp"

namespace rva {

enum class ChangeKind {
  added,    ///< nearer than before; or its depth went missing, as behind glass and on bare metal
  removed,  ///< farther than before; or depth appeared where there was none
};

/// One changed place. Pixels are of the final depth image, positions in the final depth camera's frame.
/// What a method cannot give is empty.
struct Finding {
  int id = 0;  ///< from 1, most suspicious first
  ChangeKind kind = ChangeKind::added;
  Box box;
  std::vector<std::uint32_t> pixels;  ///< changed pixels, by position in the rows laid end to end
  Eigen::Vector2d centroid{0, 0};     ///< mean of the pixels
  std::optional<Eigen::Vector3d>
      position_m;  ///< the centroid at the region's median depth, before where there is none after
  std::optional<std::array<double, 2>> size_mm;  ///< the box's width and height at that depth
  std::optional<double>
      height_mm;  ///< median change of depth over the region, along z; where half of it has both
  std::optional<double> score;  ///< larger is more suspicious; comparable within a method
  std::optional<double> p_value;
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
  std::vector<Finding> findings;  ///< most suspicious first
};

/// Measures each region of a comparison and puts the most suspicious first.
///
/// Where evidence is rarity, the score is that of the rarest pixel, and the p-value the probability that an
/// inspection without any change shows something as rare. Elsewhere the score is the mean evidence of the
/// region's pixels times the root of their number: what a sum of independent evidence comes to in deviations
/// of one pixel. Neighbours are not independent, so it ranks, and says nothing about probability.
[[nodiscard]] std::vector<Finding> measure_regions(std::vector<Region> regions, const Comparison& comparison,
                                                   const Intrinsics& camera);

/// `detections.json` (docs/detection.md), ending in a line feed.
[[nodiscard]] std::string to_json(const Findings& findings);

}  // namespace rva
