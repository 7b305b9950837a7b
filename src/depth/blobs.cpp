#include "depth/blobs.hpp"

#include <algorithm>
#include <cassert>
#include <cstring>

namespace rva {
namespace {

// Returns the first column at or after `u` that is set, or `width`. Eight empty pixels are skipped at a time,
// since most of a mask is empty.
int next_set(const std::uint8_t* row, int u, int width) {
  constexpr int word = sizeof(std::uint64_t);
  for (; u + word <= width; u += word) {
    std::uint64_t pixels = 0;
    std::memcpy(&pixels, row + u, word);
    if (pixels != 0) break;
  }
  while (u < width && row[u] == 0) ++u;
  return u;
}

int next_empty(const std::uint8_t* row, int u, int width) {
  while (u < width && row[u] != 0) ++u;
  return u;
}

}  // namespace

Blobs::Blobs(const Mask& mask) {
  find_runs(mask);
  connect_runs();
}

void Blobs::find_runs(const Mask& mask) {
  const int width = mask.width();
  for (int v = 0; v < mask.height(); ++v) {
    row_starts_.push_back(runs_.size());
    const std::uint8_t* row = mask.data() + static_cast<std::size_t>(v) * static_cast<std::size_t>(width);
    for (int first = next_set(row, 0, width); first < width;) {
      const int end = next_empty(row, first, width);
      runs_.push_back({v, first, end, 0});
      first = next_set(row, end, width);
    }
  }
  row_starts_.push_back(runs_.size());
}

void Blobs::connect_runs() {
  DisjointSets sets(runs_.size());
  for (std::size_t v = 1; v + 1 < row_starts_.size(); ++v) join_touching_runs(v, sets);
  for (std::size_t k = 0; k < runs_.size(); ++k) {
    const std::size_t first_run = sets.find(k);
    if (first_run == k) areas_.push_back(0);
    runs_[k].blob = first_run == k ? areas_.size() - 1 : runs_[first_run].blob;
    areas_[runs_[k].blob] += runs_[k].end - runs_[k].first;
  }
}

// Two runs of neighbouring rows touch when they overlap or meet at a corner; both rows are walked in step.
void Blobs::join_touching_runs(std::size_t row, DisjointSets& sets) const {
  std::size_t above = row_starts_[row - 1];
  std::size_t here = row_starts_[row];
  while (above < row_starts_[row] && here < row_starts_[row + 1]) {
    const Run& a = runs_[above];
    const Run& b = runs_[here];
    if (a.first <= b.end && b.first <= a.end) sets.join(above, here);
    if (a.end < b.end) {
      ++above;
    } else {
      ++here;
    }
  }
}

std::size_t Blobs::blob_at(int u, int v) const {
  const std::span<const Run> row = runs_of_row(v);
  const auto after = std::ranges::upper_bound(row, u, {}, &Run::first);
  assert(after != row.begin() && u < (after - 1)->end);
  return (after - 1)->blob;
}

}  // namespace rva
