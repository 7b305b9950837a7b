// Matching costs of every pixel at every disparity, and the choice of the best.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "depth/image.hpp"

namespace rva {

/// Number of disparities per pixel: the compiler vectorises every loop over disparities.
inline constexpr int cost_lanes = 128;

/// Costs of the pixels of the left image, `cost_lanes` each. At disparity d, pixel u of the left image is
/// compared with pixel u - d of the right one.
class CostVolume {
 public:
  /// All costs are 0.
  /// @param width, height size of the images, px
  CostVolume(int width, int height)
      : width_(width),
        height_(height),
        costs_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * cost_lanes, 0) {}

  /// Number of columns.
  [[nodiscard]] int width() const { return width_; }
  /// Number of rows.
  [[nodiscard]] int height() const { return height_; }
  /// The `cost_lanes` costs of pixel (u, v), by disparity.
  [[nodiscard]] std::uint16_t* at(int u, int v) { return &costs_[index(u, v)]; }
  /// @overload
  [[nodiscard]] const std::uint16_t* at(int u, int v) const { return &costs_[index(u, v)]; }

 private:
  [[nodiscard]] std::size_t index(int u, int v) const {
    return (static_cast<std::size_t>(v) * static_cast<std::size_t>(width_) + static_cast<std::size_t>(u)) *
           cost_lanes;
  }

  int width_;
  int height_;
  std::vector<std::uint16_t> costs_;
};

/// Settings of the selection of each pixel's disparity from its costs.
struct WinnerOptions {
  int search_px = 126;  ///< largest disparity, below cost_lanes - 1
  /// The best cost must be lower than any other (apart from its neighbours) by this share.
  double uniqueness = 0.03;
  int left_right_px = 1;    ///< tolerance of the left-right check
  int least_curvature = 0;  ///< least second difference of the costs at the best one
  int fraction_bits = 5;    ///< the result is rounded to 1 / 2^bits of a pixel
};

/// Chooses the least cost of each pixel of a row, with a left-right check, refined by a parabola through it
/// and its neighbours (which biases results towards whole pixels where costs are not parabolic: Shimizu and
/// Okutomi, ICCV 2001).
/// @param row_costs   `cost_lanes` for each pixel of the row, as in CostVolume
/// @param disparities result for each pixel of the left image in 1 / 2^fraction_bits px, 0 where there is
///                    no match
void choose_winners(const std::uint16_t* row_costs, int width, const WinnerOptions& options,
                    std::uint16_t* disparities);

}  // namespace rva
