// Mean and standard deviation of every pixel over many depth images.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <span>

#include "depth/image.hpp"

namespace rva {

/// Exact statistics per pixel over the frames in which the pixel has a measurement, updated frame by frame
/// (thesis chapter 3.2.3; there, pixels without a measurement count as depth 0).
///
/// Sums are integers of the deviation from the pixel's first valid depth: they take 16 bytes per pixel for
/// any number of frames, and are exact, so that results do not depend on how frames are grouped into add()
/// calls. Depths and results are in the depth units of the frames. Not for use by several threads.
class DepthStatistics {
 public:
  /// More frames would overflow the sums: this is 18 minutes at 30 Hz.
  static constexpr std::size_t max_frames = 32767;

  /// Statistics of frames of this size, in pixels; without any frame yet.
  DepthStatistics(int width, int height);

  /// Adds a frame as it arrives.
  /// @throws Error when its size differs or max_frames are reached; the statistics stay as they were
  void add(const DepthImage& frame);

  /// Adds several frames; faster than one by one, since the sums stay in the cache. @throws Error as above
  void add(std::span<const DepthImage> frames);

  /// Removes all frames, without a new allocation.
  void clear();

  /// Number of columns of a frame.
  [[nodiscard]] int width() const { return reference_.width(); }
  /// Number of rows of a frame.
  [[nodiscard]] int height() const { return reference_.height(); }
  /// Number of pixels of a frame.
  [[nodiscard]] std::size_t size() const { return reference_.size(); }
  /// Number of frames added since the last clear().
  [[nodiscard]] std::size_t frames() const { return frames_; }

  /// @name Statistics of one pixel
  /// i is the pixel's index in row-major order.
  /// @{

  /// Number of frames in which the pixel was valid.
  [[nodiscard]] std::uint32_t count(std::size_t i) const { return count_[i]; }

  /// Whether the pixel was valid in at least half of the frames, so that its mean is taken as its depth.
  [[nodiscard]] bool seen(std::size_t i) const { return count_[i] > 0 && 2U * count_[i] >= frames_; }

  /// Sum of the valid depths.
  [[nodiscard]] std::int64_t sum(std::size_t i) const {
    return std::int64_t{count_[i]} * reference_[i] + sum_[i];
  }

  /// Mean of the valid depths; 0 where there are none.
  [[nodiscard]] double mean(std::size_t i) const {
    return count_[i] == 0 ? 0.0 : static_cast<double>(sum(i)) / static_cast<double>(count_[i]);
  }

  /// count^2 times the population variance, which is an exact integer.
  [[nodiscard]] std::int64_t scaled_variance(std::size_t i) const {
    const std::int64_t deviation = sum_[i];
    return std::int64_t{count_[i]} * static_cast<std::int64_t>(sum_of_squares_[i]) - deviation * deviation;
  }

  /// Population standard deviation of the valid depths (divided by count, as numpy's); 0 for none.
  [[nodiscard]] double standard_deviation(std::size_t i) const {
    return count_[i] == 0
               ? 0.0
               : std::sqrt(static_cast<double>(scaled_variance(i))) / static_cast<double>(count_[i]);
  }

  /// @}

 private:
  void require_room_for(std::size_t frames) const;

  Image<std::uint16_t> reference_;  // first valid depth; 0 until there is one
  Image<std::uint16_t> count_;
  Image<std::int32_t> sum_;              // of deviations from the reference
  Image<std::uint64_t> sum_of_squares_;  // of deviations from the reference
  std::size_t frames_ = 0;
};

}  // namespace rva
