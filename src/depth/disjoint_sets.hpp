// Disjoint sets: which elements belong together, directly or through others.
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace rva {

/// Disjoint sets of the numbers below `count` (Tarjan 1975), with path halving. The representative of a set
/// is its smallest member.
class DisjointSets {
 public:
  /// @param count number of elements, each in a set of its own at first
  explicit DisjointSets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }

  /// The representative of the set that contains the element.
  [[nodiscard]] std::size_t find(std::size_t member) {
    while (parent_[member] != member) member = parent_[member] = parent_[parent_[member]];
    return member;
  }

  /// Unites the sets of two elements.
  void join(std::size_t a, std::size_t b) {
    a = find(a);
    b = find(b);
    parent_[a < b ? b : a] = a < b ? a : b;
  }

 private:
  std::vector<std::size_t> parent_;
};

}  // namespace rva
