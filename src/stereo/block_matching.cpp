#include "stereo/block_matching.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <vector>

#include "core/parallel.hpp"
#include "core/vector_clones.hpp"

namespace rva {

namespace {

// Number of disparities computed at once: the compiler vectorises every sum over disparities.
constexpr int lanes = 128;

/// A cost and its disparity in one number, so that the least number is the best match: halved costs, at most
/// 511, above 7 bits of disparity.
using Key = std::uint16_t;
constexpr int disparity_bits = 7;
constexpr Key worst = 0xFFFF;

constexpr int greatest_cost = worst >> disparity_bits;

Key key_of(int cost, int disparity) {
  return static_cast<Key>((std::min(cost >> 1, greatest_cost) << disparity_bits) | disparity);
}
int cost_of(Key key) { return key >> disparity_bits; }
int disparity_of(Key key) { return key & (lanes - 1); }

/// The costs of one row of pixels at all disparities, and their sums over the window, from row to row.
class CostRows {
 public:
  CostRows(const Image<std::uint16_t>& left, const Image<std::uint16_t>& right, int window_px)
      : left_(left),
        right_(right),
        window_(window_px),
        width_(left.width()),
        history_(static_cast<std::size_t>(window_px) * row_size()),
        columns_(row_size(), 0) {}

  /// Moves the window so that it is centred on row v; from row to row, v grows by one.
  void move_to(int v) {
    const int half = window_ / 2;
    if (next_ == unstarted) next_ = v - half;
    for (; next_ <= v + half; ++next_) exchange(next_);
  }

  /// Sums the column sums over the window, for all disparities. @param sums `lanes` per pixel
  void sum_along_row(std::vector<std::uint16_t>& sums) const {
    const int half = window_ / 2;
    std::uint16_t running[lanes] = {};
    for (int u = -half; u <= half; ++u) add(running, column(u));
    for (int u = 0; u < width_; ++u) {
      std::copy(running, running + lanes, &sums[static_cast<std::size_t>(u) * lanes]);
      exchange(running, column(u + half + 1), column(u - half));
    }
  }

 private:
  static constexpr int unstarted = -1000000;

  [[nodiscard]] std::size_t row_size() const { return static_cast<std::size_t>(width_) * lanes; }
  [[nodiscard]] const std::uint16_t* column(int u) const {
    return &columns_[static_cast<std::size_t>(std::clamp(u, 0, width_ - 1)) * lanes];
  }

  static void add(std::uint16_t* sums, const std::uint16_t* more) {
    for (int d = 0; d < lanes; ++d) sums[d] = static_cast<std::uint16_t>(sums[d] + more[d]);
  }
  static void exchange(std::uint16_t* sums, const std::uint16_t* in, const std::uint16_t* out) {
    for (int d = 0; d < lanes; ++d) sums[d] = static_cast<std::uint16_t>(sums[d] + in[d] - out[d]);
  }

  // Adds the costs of a row to the column sums, and subtracts those of `window` rows ago, which it replaces.
  void exchange(int row) {
    const int v = std::clamp(row, 0, left_.height() - 1);
    const int slot = ((row % window_) + window_) % window_;
    std::uint8_t* const costs = &history_[static_cast<std::size_t>(slot) * row_size()];
    // Reversed, so that increasing disparities have increasing addresses.
    std::vector<std::uint16_t> backwards(static_cast<std::size_t>(width_) + lanes, 0);
    for (int u = 0; u < width_; ++u) backwards[static_cast<std::size_t>(width_ - 1 - u)] = right_(u, v);
    for (int u = 0; u < width_; ++u) {
      exchange_pixel(left_(u, v), &backwards[static_cast<std::size_t>(width_ - 1 - u)],
                     &costs[static_cast<std::size_t>(u) * lanes],
                     &columns_[static_cast<std::size_t>(u) * lanes]);
    }
  }

  static void exchange_pixel(std::uint16_t bits, const std::uint16_t* others, std::uint8_t* costs,
                             std::uint16_t* sums) {
    for (int d = 0; d < lanes; ++d) {
      // The number of bits in which the two differ, counted in pairs, fours, eights.
      std::uint16_t x = static_cast<std::uint16_t>(bits ^ others[d]);
      x = static_cast<std::uint16_t>(x - ((x >> 1) & 0x5555));
      x = static_cast<std::uint16_t>((x & 0x3333) + ((x >> 2) & 0x3333));
      x = static_cast<std::uint16_t>((x + (x >> 4)) & 0x0F0F);
      x = static_cast<std::uint16_t>((x + (x >> 8)) & 0x1F);
      sums[d] = static_cast<std::uint16_t>(sums[d] + x - costs[d]);
      costs[d] = static_cast<std::uint8_t>(x);
    }
  }

  const Image<std::uint16_t>& left_;
  const Image<std::uint16_t>& right_;
  int window_;
  int width_;
  std::vector<std::uint8_t> history_;   // costs of the window's rows
  std::vector<std::uint16_t> columns_;  // sums over those rows
  int next_ = unstarted;
};

Key least(const Key* keys, int first, int end) {
  Key best = worst;
  for (int d = first; d < end; ++d) best = std::min(best, keys[d]);
  return best;
}

/// Best matches of one row, for either imager.
class RowWinners {
 public:
  RowWinners(int width, const BlockMatchingOptions& options)
      : options_(options),
        left_(static_cast<std::size_t>(width)),
        right_(static_cast<std::size_t>(width) + lanes) {}

  void choose(const std::vector<std::uint16_t>& sums) {
    std::fill(right_.begin(), right_.end(), worst);
    for (std::size_t u = 0; u < left_.size(); ++u) choose(static_cast<int>(u), &sums[u * lanes]);
  }

  void write(std::uint8_t* disparities) const {
    for (std::size_t u = 0; u < left_.size(); ++u) {
      const int disparity = left_[u];
      if (disparity == no_match) continue;
      const int back = disparity_of(right_backwards(static_cast<int>(u) - disparity));
      if (std::abs(back - disparity) <= options_.left_right_px)
        disparities[u] = static_cast<std::uint8_t>(disparity);
    }
  }

 private:
  // Reversed, like the costs: the match of pixel u at disparity d has index last - u + d.
  [[nodiscard]] Key right_backwards(int u) const {
    return right_[left_.size() - 1 - static_cast<std::size_t>(u)];
  }

  void choose(int u, const std::uint16_t* sums) {
    const int end = std::min(options_.search_px, u) + 1;
    Key keys[lanes];
    for (int d = 0; d < lanes; ++d) keys[d] = key_of(sums[d], d);
    Key* const right = &right_[left_.size() - 1 - static_cast<std::size_t>(u)];
    for (int d = 1; d < end; ++d) right[d] = std::min(right[d], keys[d]);
    const Key best = least(keys, 1, end);
    const int disparity = disparity_of(best);
    const Key second = std::min(least(keys, 1, disparity - 1), least(keys, disparity + 2, end));
    const bool unique = cost_of(best) < cost_of(second) * (1.0 - options_.uniqueness);
    // At the left edge there may be no other cost to compare with.
    const bool compared = best != worst && second != worst;
    left_[static_cast<std::size_t>(u)] = compared && unique ? static_cast<std::uint8_t>(disparity) : no_match;
  }

  BlockMatchingOptions options_;
  std::vector<std::uint8_t> left_;
  std::vector<Key> right_;
};

RVA_VECTOR_CLONES
void match_rows(const Image<std::uint16_t>& left_census, const Image<std::uint16_t>& right_census,
                const BlockMatchingOptions& options, int first, int end, Image<std::uint8_t>& disparities) {
  CostRows costs(left_census, right_census, options.window_px);
  RowWinners winners(disparities.width(), options);
  std::vector<std::uint16_t> sums(static_cast<std::size_t>(disparities.width()) * lanes);
  for (int v = first; v < end; ++v) {
    costs.move_to(v);
    costs.sum_along_row(sums);
    winners.choose(sums);
    winners.write(&disparities(0, v));
  }
}

}  // namespace

Image<std::uint8_t> match_blocks(const InfraredImage& left, const InfraredImage& right,
                                 const BlockMatchingOptions& options) {
  assert(left.same_size(right) && options.search_px < lanes && options.window_px % 2 == 1);
  const Image<std::uint16_t> left_census = census(left, options.census_threshold);
  const Image<std::uint16_t> right_census = census(right, options.census_threshold);
  Image<std::uint8_t> disparities(left.width(), left.height(), no_match);
  parallel_bands(left.height(), [&](int first, int end) {
    match_rows(left_census, right_census, options, first, end, disparities);
  });
  return disparities;
}

}  // namespace rva
