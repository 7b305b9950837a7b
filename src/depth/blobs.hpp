// Connected components (blobs) of a mask, stored as runs of pixels.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "depth/disjoint_sets.hpp"
#include "depth/image.hpp"

namespace rva {

/// A run of set pixels in one row, columns [first, end), that belongs to one blob.
struct Run {
  int v = 0;             ///< row
  int first = 0;         ///< first column
  int end = 0;           ///< column after the last one
  std::size_t blob = 0;  ///< index of its blob, from 0
};

/// The 8-connected blobs of a mask. They are found in one pass over the pixels and one over the runs, so that
/// a mask with few set pixels costs little more than reading it.
class Blobs {
 public:
  /// @param mask pixels other than 0 are set
  explicit Blobs(const Mask& mask);

  /// Number of blobs.
  [[nodiscard]] std::size_t count() const { return areas_.size(); }
  /// All runs, from top to bottom, then from left to right.
  [[nodiscard]] const std::vector<Run>& runs() const { return runs_; }
  /// The runs of one row, from left to right.
  [[nodiscard]] std::span<const Run> runs_of_row(int v) const {
    const auto row = static_cast<std::size_t>(v);
    return std::span(runs_).subspan(row_starts_[row], row_starts_[row + 1] - row_starts_[row]);
  }
  /// Number of pixels of a blob.
  [[nodiscard]] int area_px(std::size_t blob) const { return areas_[blob]; }
  /// The blob that contains a pixel, which must be set.
  [[nodiscard]] std::size_t blob_at(int u, int v) const;

 private:
  void find_runs(const Mask& mask);
  void connect_runs();
  void join_touching_runs(std::size_t row, DisjointSets& sets) const;

  std::vector<Run> runs_;
  std::vector<std::size_t> row_starts_;  // index in runs_ at which row v starts, and the end of the last row
  std::vector<int> areas_;
};

}  // namespace rva
