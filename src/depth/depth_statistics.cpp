#include "depth/depth_statistics.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/error.hpp"
#include "depth/depth_statistics_kernel.hpp"

namespace rva {
namespace kernel {

// Equation 4 of docs/math.md.
void add_pass_portable(const std::uint16_t* const* frames, std::size_t count, std::size_t pixels,
                       const Sums& sums) {
  for (std::size_t frame = 0; frame < count; ++frame) {
    const std::uint16_t* depths = frames[frame];
    for (std::size_t i = 0; i < pixels; ++i) {
      const std::uint16_t depth = depths[i];
      if (depth == no_depth) continue;
      if (sums.reference[i] == no_depth) sums.reference[i] = depth;
      const std::int32_t deviation = std::int32_t{depth} - std::int32_t{sums.reference[i]};
      const std::int64_t square = std::int64_t{deviation} * deviation;
      sums.count[i] = static_cast<std::uint16_t>(sums.count[i] + 1U);
      sums.sum[i] += deviation;
      sums.sum_of_squares[i] += static_cast<std::uint64_t>(square);
    }
  }
}

}  // namespace kernel

namespace {

// Pixels that are processed in all frames before the next ones are: their sums, 16 bytes each, stay in the
// second level cache, and each frame is read in runs long enough for the processor to prefetch.
constexpr std::size_t tile_pixels = 4096;

}  // namespace

DepthStatistics::DepthStatistics(int width, int height)
    : reference_(width, height), count_(width, height), sum_(width, height), sum_of_squares_(width, height) {}

void DepthStatistics::require_room_for(std::size_t frames) const {
  if (frames_ + frames > max_frames) {
    throw Error("statistics", fmt::format("more than {} frames in one set of statistics", max_frames),
                "use fewer frames");
  }
}

void DepthStatistics::clear() {
  std::ranges::fill(reference_.pixels(), no_depth);
  std::ranges::fill(count_.pixels(), std::uint16_t{0});
  std::ranges::fill(sum_.pixels(), 0);
  std::ranges::fill(sum_of_squares_.pixels(), std::uint64_t{0});
  frames_ = 0;
}

void DepthStatistics::add(const DepthImage& frame) { add(std::span(&frame, 1)); }

void DepthStatistics::add(std::span<const DepthImage> frames) {
  require_room_for(frames.size());
  for (const DepthImage& frame : frames) {
    if (frame.same_size(reference_)) continue;
    throw Error("statistics",
                fmt::format("a frame has {}x{} pixels, but others have {}x{}", frame.width(), frame.height(),
                            width(), height()),
                "record all frames at one size");
  }
  const kernel::AddPass add_pass = kernel::has_avx2() ? kernel::add_pass_avx2 : kernel::add_pass_portable;
  for (std::size_t start = 0; start < size(); start += tile_pixels) {
    const std::size_t pixels = std::min(tile_pixels, size() - start);
    const kernel::Sums sums{reference_.data() + start, count_.data() + start, sum_.data() + start,
                            sum_of_squares_.data() + start};
    for (std::size_t first = 0; first < frames.size(); first += kernel::frames_per_pass) {
      const std::size_t in_pass = std::min(kernel::frames_per_pass, frames.size() - first);
      std::array<const std::uint16_t*, kernel::frames_per_pass> runs{};
      for (std::size_t k = 0; k < in_pass; ++k) runs[k] = frames[first + k].data() + start;
      add_pass(runs.data(), in_pass, pixels, sums);
    }
  }
  frames_ += frames.size();
}

}  // namespace rva
