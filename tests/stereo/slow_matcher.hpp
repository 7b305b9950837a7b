// A matcher to compare with: slow, and nothing shared with the fast one but the census.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <limits>
#include <vector>

#include "stereo/block_matching.hpp"
#include "tests/stereo/random_images.hpp"

namespace rva::test {

/// Block matching as documented in its header, pixel by pixel. Costs are compared in steps of two.
class SlowMatcher {
 public:
  SlowMatcher(const StereoPair& pair, const BlockMatchingOptions& options)
      : left_(census(pair.left, options.census_threshold)),
        right_(census(pair.right, options.census_threshold)),
        options_(options) {
    for (int v = 0; v < left_.height(); ++v) {
      for (int u = 0; u < left_.width(); ++u) {
        for (int d = 1; d <= options.search_px; ++d)
          costs_.push_back(d <= u ? window_cost(u, v, d) / 2 : none);
      }
    }
  }

  [[nodiscard]] int match(int u, int v) const {
    const int best = best_of_left(u, v);
    if (best == no_match || !unique(u, v, best)) return no_match;
    return std::abs(best_of_right(u - best, v) - best) <= options_.left_right_px ? best : no_match;
  }

 private:
  static constexpr int none = std::numeric_limits<int>::max();

  [[nodiscard]] int cost(int u, int v, int d) const {
    const int pixel = v * left_.width() + u;
    return costs_[static_cast<std::size_t>(pixel * options_.search_px + d - 1)];
  }
  [[nodiscard]] int window_cost(int u, int v, int d) const {
    const int half = options_.window_px / 2;
    int sum = 0;
    for (int j = v - half; j <= v + half; ++j) {
      for (int i = u - half; i <= u + half; ++i) sum += pixel_cost(i, j, d);
    }
    return sum;
  }
  // The nearest pixel of the left image; beside the right one there is nothing, which has no bits.
  [[nodiscard]] int pixel_cost(int u, int v, int d) const {
    const int column = std::clamp(u, 0, left_.width() - 1);
    const int row = std::clamp(v, 0, left_.height() - 1);
    const unsigned other = column >= d ? right_(column - d, row) : 0U;
    return std::popcount(left_(column, row) ^ other);
  }
  [[nodiscard]] int best_of_left(int u, int v) const {
    int best = no_match;
    for (int d = 1; d <= std::min(u, options_.search_px); ++d) {
      if (best == no_match || cost(u, v, d) < cost(u, v, best)) best = d;
    }
    return best;
  }
  [[nodiscard]] int best_of_right(int u, int v) const {
    int best = no_match;
    for (int d = 1; d <= std::min(left_.width() - 1 - u, options_.search_px); ++d) {
      if (best == no_match || cost(u + d, v, d) < cost(u + best, v, best)) best = d;
    }
    return best;
  }
  [[nodiscard]] bool unique(int u, int v, int best) const {
    int second = none;
    for (int d = 1; d <= options_.search_px; ++d) {
      if (std::abs(d - best) > 1) second = std::min(second, cost(u, v, d));
    }
    return second != none && cost(u, v, best) < second * (1.0 - options_.uniqueness);
  }

  Image<std::uint16_t> left_;
  Image<std::uint16_t> right_;
  BlockMatchingOptions options_;
  std::vector<int> costs_;  // of a pixel's disparities from 1, `none` where they leave the image
};

}  // namespace rva::test
