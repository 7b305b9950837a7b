// Findings taken apart into their connected pieces: a finding joins what lies close, such as several parts.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "detect/findings/detection.hpp"
#include "plan/baseline_view.hpp"

namespace rva {

/// A connected piece of a finding, measured by itself. Pixels are those of the final depth image.
struct Piece {
  std::size_t finding = 0;              ///< index of its finding
  ChangeKind kind = ChangeKind::added;  ///< that of the finding
  Box box;                              ///< in the final depth image
  std::vector<std::uint32_t> pixels;    ///< as indices in row-major order, ascending
  std::optional<double> depth_m;        ///< median depth, after the work or else before, final camera
  /// Decrease of depth, along z, as of Finding: negative if it went farther; empty where it is not measured
  /// on both sides.
  std::optional<double> height_mm;
  std::optional<double> above_surroundings_mm;  ///< as of Finding
  std::optional<double> level_mm;  ///< median level of detection over its pixels, if there is one
  std::vector<Eigen::Vector2d>
      outline;                     ///< its pixels in the baseline's picture; empty where it is not seen there
  Eigen::Vector2d centroid{0, 0};  ///< mean of `outline`
};

/// The pieces of all findings, in an order that depends on the pixels alone. Pixels of a finding that are
/// no more than 2 pixels apart belong to one piece.
[[nodiscard]] std::vector<Piece> pieces_of(const Detection& detection, const BaselineView& baseline);

}  // namespace rva
