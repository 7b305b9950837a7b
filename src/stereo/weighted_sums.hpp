// Sums over a window around each pixel, with weights that decrease towards its edge.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "core/parallel.hpp"
#include "depth/image.hpp"

namespace rva {

/// Weights along one side of a square window; the weight of a pixel is the product of those of its row and
/// column. They decrease towards the edge, so that a dot that enters the window changes the sums gradually.
struct WindowWeights {
  static constexpr int lanes = 16;    ///< 16-bit numbers in a row of a window; unused ones have weight 0
  static constexpr int most_px = 11;  ///< largest edge, so that five shifted windows fit into a row
  static constexpr int greatest = 4;  ///< weight of the middle
  /// The weights of one row of a window.
  using Row = std::array<std::int16_t, lanes>;

  /// @param edge_px odd, 1 to most_px
  explicit WindowWeights(int edge_px) : window_px(edge_px), half_px(edge_px / 2) {
    for (int i = 0; i < edge_px; ++i)
      along[static_cast<std::size_t>(i)] =
          static_cast<std::int16_t>(std::min({i + 1, edge_px - i, greatest}));
    for (std::size_t row = 0; row < rows.size(); ++row) {
      for (std::size_t i = 0; i < along.size(); ++i)
        rows[row][i] = static_cast<std::int16_t>(along[row] * along[i]);
    }
  }
  /// Sum of the weights of all pixels.
  [[nodiscard]] std::int32_t total() const {
    std::int32_t sum = 0;
    for (const std::int16_t weight : along) sum += weight;
    return sum * sum;
  }

  int window_px;                    ///< edge, odd
  int half_px;                      ///< half of the edge, rounded down
  Row along{};                      ///< weights along one side
  std::array<Row, most_px> rows{};  ///< of the whole window
};

/// Adds weight times from[i] to sums[i].
void add_weighted(std::int32_t weight, const std::int32_t* from, int count, std::int32_t* sums);

/// The weighted sums of one quantity around every pixel. Border pixels are repeated outside the image.
class WeightedSums {
 public:
  static constexpr int border_px = 24;  ///< sums extend this far to the left and right of the image

  /// @param value returns the quantity at (u, v) inside the image
  template <typename Value>
  WeightedSums(int width, int height, const WindowWeights& weights, Value value)
      : sums_(width + 2 * border_px, height) {
    Image<std::int32_t> values(width, height);
    parallel_bands(height, [&](int first, int end) {
      for (int v = first; v < end; ++v) {
        for (int u = 0; u < width; ++u) values(u, v) = value(u, v);
      }
    });
    parallel_bands(height, [&](int first, int end) {
      const int margin = border_px + weights.half_px;
      Image<std::int32_t> columns(width + 2 * margin, 1);
      for (int v = first; v < end; ++v) {
        std::fill(columns.pixels().begin(), columns.pixels().end(), 0);
        for (int i = 0; i < weights.window_px; ++i) {
          const int row = std::clamp(v - weights.half_px + i, 0, height - 1);
          add_weighted(weights.along[static_cast<std::size_t>(i)], &values(0, row), width,
                       &columns(margin, 0));
        }
        std::fill_n(&columns(0, 0), margin, columns(margin, 0));
        std::fill_n(&columns(margin + width, 0), margin, columns(margin + width - 1, 0));
        for (int i = 0; i < weights.window_px; ++i)
          add_weighted(weights.along[static_cast<std::size_t>(i)], &columns(i, 0), sums_.width(),
                       &sums_(0, v));
      }
    });
  }

  /// The sum around pixel (u, v).
  /// @param u from -border_px to below width + border_px
  [[nodiscard]] std::int32_t operator()(int u, int v) const { return sums_(u + border_px, v); }

 private:
  Image<std::int32_t> sums_;
};

}  // namespace rva
