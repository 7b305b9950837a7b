#include "stereo/semi_global.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <vector>

#include "core/parallel.hpp"
#include "core/vector_clones.hpp"
#include "stereo/cost_volume.hpp"

namespace rva {
namespace {

/// Costs along one path at one pixel, padded on either side so that neighbours need no range check.
struct PathCosts {
  static constexpr std::uint16_t out_of_range = 0x3FFF;
  std::array<std::uint16_t, cost_lanes + 2> padded{};
  std::uint16_t least = 0;

  PathCosts() { padded.front() = padded.back() = out_of_range; }
  std::uint16_t* costs() { return padded.data() + 1; }
  [[nodiscard]] const std::uint16_t* costs() const { return padded.data() + 1; }
};

class CensusCosts {
 public:
  CensusCosts(const InfraredImage& left, const InfraredImage& right, int threshold)
      : left_(census(left, threshold)), right_(census(right, threshold)) {}

  // Number of bits in which two pixels differ, at all disparities. Outside the image, the first pixel
  // is repeated.
  void at(int u, int v, std::array<std::uint16_t, cost_lanes>& costs) const {
    std::array<std::uint16_t, cost_lanes> others{};
    const int inside = std::min(u, cost_lanes - 1);
    for (int d = 0; d <= inside; ++d) others[static_cast<std::size_t>(d)] = right_(u - d, v);
    std::fill(others.begin() + inside, others.end(), right_(u - inside, v));
    const std::uint16_t bits = left_(u, v);
    for (std::size_t d = 0; d < cost_lanes; ++d) {
      auto x = static_cast<std::uint16_t>(bits ^ others[d]);
      x = static_cast<std::uint16_t>(x - ((x >> 1) & 0x5555));
      x = static_cast<std::uint16_t>((x & 0x3333) + ((x >> 2) & 0x3333));
      x = static_cast<std::uint16_t>((x + (x >> 4)) & 0x0F0F);
      costs[d] = static_cast<std::uint16_t>((x + (x >> 8)) & 0x1F);
    }
  }

 private:
  Image<std::uint16_t> left_;
  Image<std::uint16_t> right_;
};

// One step along a path (Hirschmueller's equation 13), added to the sums of all paths.
void advance(const std::array<std::uint16_t, cost_lanes>& costs, const SemiGlobalOptions& options,
             PathCosts& path, std::uint16_t* sums) {
  PathCosts next;
  const std::uint16_t* const before = path.costs();
  const int jump = path.least + options.large_step;
  std::uint16_t least = PathCosts::out_of_range;
  for (int d = 0; d < cost_lanes; ++d) {
    int cheapest = std::min<int>(before[d], jump);
    cheapest = std::min(cheapest, std::min(before[d - 1], before[d + 1]) + options.small_step);
    const auto cost = static_cast<std::uint16_t>(costs[static_cast<std::size_t>(d)] + cheapest - path.least);
    next.costs()[d] = cost;
    least = std::min(least, cost);
    sums[d] = static_cast<std::uint16_t>(sums[d] + cost);
  }
  next.least = least;
  path = next;
}

RVA_VECTOR_CLONES
void sum_along_rows(const CensusCosts& census, const SemiGlobalOptions& options, int first, int end,
                    CostVolume& sums) {
  std::array<std::uint16_t, cost_lanes> costs{};
  for (int v = first; v < end; ++v) {
    PathCosts to_the_right;
    PathCosts to_the_left;
    for (int u = 0; u < sums.width(); ++u) {
      census.at(u, v, costs);
      advance(costs, options, to_the_right, sums.at(u, v));
    }
    for (int u = sums.width() - 1; u >= 0; --u) {
      census.at(u, v, costs);
      advance(costs, options, to_the_left, sums.at(u, v));
    }
  }
}

RVA_VECTOR_CLONES
void sum_along_columns(const CensusCosts& census, const SemiGlobalOptions& options, int first, int end,
                       CostVolume& sums) {
  std::array<std::uint16_t, cost_lanes> costs{};
  for (const bool down : {true, false}) {
    std::vector<PathCosts> paths(static_cast<std::size_t>(end - first));
    for (int row = 0; row < sums.height(); ++row) {
      const int v = down ? row : sums.height() - 1 - row;
      for (int u = first; u < end; ++u) {
        census.at(u, v, costs);
        advance(costs, options, paths[static_cast<std::size_t>(u - first)], sums.at(u, v));
      }
    }
  }
}

}  // namespace

Image<std::uint16_t> match_semi_globally(const InfraredImage& left, const InfraredImage& right,
                                         const SemiGlobalOptions& options) {
  assert(left.same_size(right));
  const CensusCosts census(left, right, options.census_threshold);
  CostVolume sums(left.width(), left.height());
  parallel_bands(left.height(),
                 [&](int first, int end) { sum_along_rows(census, options, first, end, sums); });
  parallel_bands(left.width(),
                 [&](int first, int end) { sum_along_columns(census, options, first, end, sums); });
  const WinnerOptions winners{.uniqueness = options.uniqueness};
  Image<std::uint16_t> disparities(left.width(), left.height(), 0);
  parallel_bands(left.height(), [&](int first, int end) {
    for (int v = first; v < end; ++v)
      choose_winners(sums.at(0, v), left.width(), winners, &disparities(0, v));
  });
  return disparities;
}

}  // namespace rva
