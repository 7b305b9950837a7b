#include "scene/solids/triangulation.hpp"

#include <algorithm>
#include <cassert>
#include <cstddef>
#include <limits>
#include <optional>
#include <utility>

namespace rva {
namespace {

using Points = std::span<const Eigen::Vector2d>;
using Edge = std::pair<std::uint32_t, std::uint32_t>;

/// Twice the area of a triangle, positive when it runs counterclockwise.
double turn(const Eigen::Vector2d& a, const Eigen::Vector2d& b, const Eigen::Vector2d& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Connects the holes to the outline by bridges, along which the resulting single loop runs
/// in both directions.
class HoleBridges {
 public:
  HoleBridges(Points points, std::span<const Loop> loops)
      : points_(points),
        loop_(loops.front()),
        holes_(loops.begin() + 1, loops.end()),
        bridged_(points.size(), false) {
    for (const Loop& loop : loops) {
      for (std::size_t i = 0; i < loop.size(); ++i) edges_.emplace_back(loop[i], loop[(i + 1) % loop.size()]);
    }
  }

  [[nodiscard]] Loop joined() {
    while (!holes_.empty()) {
      const std::optional<Bridge> bridge = shortest();
      assert(bridge);  // loops that neither touch nor cross always have a bridge that crosses no edge
      if (!bridge) break;
      build(*bridge);
    }
    return std::move(loop_);
  }

 private:
  struct Bridge {
    std::size_t hole;       ///< index into holes_
    std::size_t from_hole;  ///< index into that hole
    std::size_t from_loop;  ///< index into loop_
  };

  [[nodiscard]] std::optional<Bridge> shortest() const {
    std::optional<Bridge> best;
    double best_length = std::numeric_limits<double>::infinity();
    for (std::size_t hole = 0; hole < holes_.size(); ++hole) {
      for (std::size_t i = 0; i < holes_[hole].size(); ++i) {
        const Bridge candidate{hole, i, nearest_in_loop(holes_[hole][i], best_length)};
        if (candidate.from_loop == loop_.size()) continue;
        best_length = length({holes_[hole][i], loop_[candidate.from_loop]});
        best = candidate;
      }
    }
    return best;
  }

  /// The nearest corner of the loop visible from the point and nearer than `limit`; loop_.size() if none.
  [[nodiscard]] std::size_t nearest_in_loop(std::uint32_t point, double limit) const {
    std::size_t nearest = loop_.size();
    for (std::size_t i = 0; i < loop_.size(); ++i) {
      // A second bridge from one corner could leave on the wrong side of the first.
      const Edge bridge(point, loop_[i]);
      if (bridged_[loop_[i]] || length(bridge) >= limit || crosses_an_edge(bridge)) continue;
      nearest = i;
      limit = length(bridge);
    }
    return nearest;
  }

  [[nodiscard]] double length(const Edge& edge) const {
    return (points_[edge.first] - points_[edge.second]).norm();
  }

  [[nodiscard]] bool crosses_an_edge(const Edge& bridge) const {
    return std::any_of(edges_.begin(), edges_.end(), [&](const Edge& edge) { return cross(bridge, edge); });
  }

  [[nodiscard]] bool cross(const Edge& one, const Edge& other) const {
    if (one.first == other.first || one.first == other.second) return false;
    if (one.second == other.first || one.second == other.second) return false;
    const auto separated = [&](const Edge& line, const Edge& ends) {
      const double first = turn(points_[line.first], points_[line.second], points_[ends.first]);
      const double second = turn(points_[line.first], points_[line.second], points_[ends.second]);
      return (first > 0 && second > 0) || (first < 0 && second < 0);
    };
    return !separated(one, other) && !separated(other, one);
  }

  void build(const Bridge& bridge) {
    Loop hole = std::move(holes_[bridge.hole]);
    holes_.erase(holes_.begin() + static_cast<std::ptrdiff_t>(bridge.hole));
    std::rotate(hole.begin(), hole.begin() + static_cast<std::ptrdiff_t>(bridge.from_hole), hole.end());
    const std::uint32_t there = hole.front();
    const std::uint32_t here = loop_[bridge.from_loop];
    bridged_[there] = bridged_[here] = true;
    edges_.emplace_back(here, there);
    hole.insert(hole.end(), {there, here});
    loop_.insert(loop_.begin() + static_cast<std::ptrdiff_t>(bridge.from_loop) + 1, hole.begin(), hole.end());
  }

  Points points_;
  Loop loop_;
  std::vector<Loop> holes_;
  std::vector<bool> bridged_;
  std::vector<Edge> edges_;
};

/// Whether the triangle of a corner and its neighbours lies inside the loop and contains no other corner.
bool is_ear(Points points, const Loop& loop, std::uint32_t before, std::uint32_t corner,
            std::uint32_t after) {
  const Eigen::Vector2d& a = points[before];
  const Eigen::Vector2d& b = points[corner];
  const Eigen::Vector2d& c = points[after];
  if (turn(a, b, c) <= 0) return false;
  return std::none_of(loop.begin(), loop.end(), [&](std::uint32_t other) {
    if (other == before || other == corner || other == after) return false;
    const Eigen::Vector2d& p = points[other];
    return turn(a, b, p) >= 0 && turn(b, c, p) >= 0 && turn(c, a, p) >= 0;
  });
}

}  // namespace

std::vector<std::array<std::uint32_t, 3>> triangulate(Points points, std::span<const Loop> loops) {
  Loop loop = HoleBridges(points, loops).joined();
  std::vector<std::array<std::uint32_t, 3>> triangles;
  std::size_t corner = 0;
  std::size_t refused = 0;
  // Every simple polygon has an ear; if rounding hides the last ones, the remaining polygon has no area.
  while (loop.size() >= 3 && refused < loop.size()) {
    corner %= loop.size();
    const std::uint32_t before = loop[(corner + loop.size() - 1) % loop.size()];
    const std::uint32_t after = loop[(corner + 1) % loop.size()];
    if (is_ear(points, loop, before, loop[corner], after)) {
      triangles.push_back({before, loop[corner], after});
      loop.erase(loop.begin() + static_cast<std::ptrdiff_t>(corner));
      refused = 0;
    } else {
      ++refused;
    }
    ++corner;  // after a cut this skips one corner, so that triangles do not fan out from one point
  }
  assert(loop.size() < 3);
  return triangles;
}

}  // namespace rva
