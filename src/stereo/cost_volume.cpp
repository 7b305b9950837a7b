#include "stereo/cost_volume.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <limits>

#include "core/vector_clones.hpp"

namespace rva {
namespace {

constexpr std::uint16_t worst = std::numeric_limits<std::uint16_t>::max();

// A cost with its disparity in the low bits: the minimum is the lowest disparity of the least cost.
constexpr int disparity_bits = 7;
static_assert(cost_lanes == 1 << disparity_bits);

std::uint32_t ranked(std::uint16_t cost, int disparity) {
  return (static_cast<std::uint32_t>(cost) << disparity_bits) | static_cast<std::uint32_t>(disparity);
}

int disparity_of(std::uint32_t rank) { return static_cast<int>(rank & (cost_lanes - 1U)); }

/// Costs of one row, for either imager.
class Row {
 public:
  Row(const std::uint16_t* costs, int width, const WinnerOptions& options)
      : costs_(costs),
        options_(options),
        width_(width),
        right_(static_cast<std::size_t>(width) + cost_lanes, std::numeric_limits<std::uint32_t>::max()) {
    for (int u = 0; u < width; ++u) {
      const std::uint16_t* const cost = at(u);
      std::uint32_t* const right = &right_[backwards(u)];
      const int most = std::min(options.search_px, u);
      for (int d = 1; d <= most; ++d) right[d] = std::min(right[d], ranked(cost[d], d));
    }
  }

  // Disparity of a pixel in 1 / 2^fraction_bits px; 0 if there is no match.
  [[nodiscard]] std::uint16_t disparity(int u) const {
    const std::uint16_t* const cost = at(u);
    const int most = std::min(options_.search_px, u);
    if (most < 3) return 0;
    const int best = best_of(cost, most);
    if (!is_unique(cost, best, most) || !agrees(u, best) || best == 1 || best == most) return 0;
    const int curvature = cost[best - 1] - 2 * cost[best] + cost[best + 1];
    if (curvature <= 0 || curvature < options_.least_curvature) return 0;
    const double offset = 0.5 * (cost[best - 1] - cost[best + 1]) / curvature;
    return static_cast<std::uint16_t>(std::lround(std::ldexp(best + offset, options_.fraction_bits)));
  }

 private:
  [[nodiscard]] const std::uint16_t* at(int u) const {
    return costs_ + static_cast<std::ptrdiff_t>(u) * cost_lanes;
  }
  // Index of a pixel of the right image, from the last to the first, so that increasing disparities have
  // increasing addresses.
  [[nodiscard]] std::size_t backwards(int u) const { return static_cast<std::size_t>(width_ - 1 - u); }

  static int best_of(const std::uint16_t* cost, int most) {
    std::uint32_t best = std::numeric_limits<std::uint32_t>::max();
    for (int d = 1; d <= most; ++d) best = std::min(best, ranked(cost[d], d));
    return disparity_of(best);
  }
  [[nodiscard]] bool is_unique(const std::uint16_t* cost, int best, int most) const {
    const auto least_beyond = [cost](int first, int end) {
      std::uint16_t least = worst;
      for (int d = first; d < end; ++d) least = std::min(least, cost[d]);
      return least;
    };
    const std::uint16_t second = std::min(least_beyond(1, best - 1), least_beyond(best + 2, most + 1));
    return second != worst && cost[best] < second * (1.0 - options_.uniqueness);
  }
  [[nodiscard]] bool agrees(int u, int best) const {
    const int back = disparity_of(right_[backwards(u - best)]);
    return std::abs(back - best) <= options_.left_right_px;
  }

  const std::uint16_t* costs_;
  const WinnerOptions& options_;
  int width_;
  std::vector<std::uint32_t> right_;
};

}  // namespace

RVA_VECTOR_CLONES
void choose_winners(const std::uint16_t* row_costs, int width, const WinnerOptions& options,
                    std::uint16_t* disparities) {
  const Row row(row_costs, width, options);
  for (int u = 0; u < width; ++u) disparities[u] = row.disparity(u);
}

}  // namespace rva
