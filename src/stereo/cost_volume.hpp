// Matching costs of every pixel at every disparity, and the best of them.
#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "depth/image.hpp"

namespace rva {

/// Disparities are lanes: of every loop over disparities the compiler makes vector instructions.
inline constexpr int cost_lanes = 128;

/// Costs of the left image's pixels, `cost_lanes` each: what pixel u sees, the right imager sees at u -
/// disparity.
class CostVolume {
 public:
  CostVolume(int width, int height)
      : width_(width),
        height_(height),
        costs_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * cost_lanes, 0) {}

  [[nodiscard]] int width() const { return width_; }
  [[nodiscard]] int height() const { return height_; }
  [[nodiscard]] std::uint16_t* at(int u, int v) { return &costs_[index(u, v)]; }
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

struct WinnerOptions {
  int search_px = 126;  ///< largest disparity, below cost_lanes - 1
  double uniqueness =
      0.03;  ///< the best cost must be lower than any other (apart from its neighbours) by this share
  int left_right_px = 1;    ///< how far the match of the match may be from where it began
  int least_curvature = 0;  ///< of the costs beside the best one; flatter ones tell nothing
  int fraction_bits = 5;    ///< the answer is rounded to 1 / 2^bits of a pixel
};

/// The least cost of each pixel of a row, checked from right to left, refined by a parabola through it and
/// its neighbours (which draws answers towards whole pixels where costs are not parabolas: Shimizu and
/// Okutomi, ICCV 2001).
/// @param row_costs   `cost_lanes` for each pixel of the row, as CostVolume has them
/// @param disparities of each pixel of the left image in 1 / 2^fraction_bits px, 0 where there is no match
void choose_winners(const std::uint16_t* row_costs, int width, const WinnerOptions& options,
                    std::uint16_t* disparities);

}  // namespace rva
