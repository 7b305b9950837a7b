#include "sim/sensor/cost_volume.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel.hpp"

namespace rva {
namespace {

constexpr std::uint16_t worst = std::numeric_limits<std::uint16_t>::max();

/// The best disparity of one row, seen from either imager.
class Row {
 public:
  Row(const CostVolume& costs, const WinnerOptions& options, int v)
      : costs_(costs),
        options_(options),
        v_(v),
        right_cost_(static_cast<std::size_t>(costs.width()), worst),
        right_(static_cast<std::size_t>(costs.width()), 0) {
    for (int u = 0; u < costs.width(); ++u) {
      const std::uint16_t* const cost = costs.at(u, v);
      const int most = std::min(options.search_px, u);
      for (int d = 1; d <= most; ++d) {
        const auto other = static_cast<std::size_t>(u - d);
        if (cost[d] >= right_cost_[other]) continue;
        right_cost_[other] = cost[d];
        right_[other] = static_cast<std::uint8_t>(d);
      }
    }
  }

  // 0 where there is none.
  [[nodiscard]] std::uint16_t disparity(int u) const {
    const std::uint16_t* const cost = costs_.at(u, v_);
    const int most = std::min(options_.search_px, u);
    if (most < 3) return 0;
    const int best = static_cast<int>(std::min_element(cost + 1, cost + most + 1) - cost);
    if (!is_unique(cost, best, most) || !agrees(u, best) || best == 1 || best == most) return 0;
    const int curvature = cost[best - 1] - 2 * cost[best] + cost[best + 1];
    if (curvature <= 0 || curvature < options_.least_curvature) return 0;
    const double offset = 0.5 * (cost[best - 1] - cost[best + 1]) / curvature;
    return static_cast<std::uint16_t>(std::lround(std::ldexp(best + offset, options_.fraction_bits)));
  }

 private:
  [[nodiscard]] bool is_unique(const std::uint16_t* cost, int best, int most) const {
    std::uint16_t second = worst;
    for (int d = 1; d <= most; ++d) {
      if (std::abs(d - best) > 1) second = std::min(second, cost[d]);
    }
    return second != worst && cost[best] < second * (1.0 - options_.uniqueness);
  }
  [[nodiscard]] bool agrees(int u, int best) const {
    return std::abs(right_[static_cast<std::size_t>(u - best)] - best) <= options_.left_right_px;
  }

  const CostVolume& costs_;
  const WinnerOptions& options_;
  int v_;
  std::vector<std::uint16_t> right_cost_;
  std::vector<std::uint8_t> right_;
};

}  // namespace

Image<std::uint16_t> choose_winners(const CostVolume& costs, const WinnerOptions& options) {
  Image<std::uint16_t> disparities(costs.width(), costs.height(), 0);
  parallel_bands(costs.height(), [&](int first, int end) {
    for (int v = first; v < end; ++v) {
      const Row row(costs, options, v);
      for (int u = 0; u < costs.width(); ++u) disparities(u, v) = row.disparity(u);
    }
  });
  return disparities;
}

}  // namespace rva
