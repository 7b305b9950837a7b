#include "stereo/correlation.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstdlib>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/parallel.hpp"
#include "core/vector_clones.hpp"
#include "depth/mat_view.hpp"
#include "stereo/cost_volume.hpp"

namespace rva {
namespace {

// Larger differences carry no more information. Sums over 13 x 13 pixels of this stay within 16 bits.
constexpr int most_difference = 255;

// Subtracts the mean around each pixel; the result has ten bits and a sign.
Image<std::int16_t> band_passed(const InfraredImage& image, int mean_px) {
  cv::Mat mean;
  const cv::Mat pixels(image.height(), image.width(), CV_16U, const_cast<std::uint16_t*>(image.data()));
  cv::blur(pixels, mean, {mean_px, mean_px}, {-1, -1}, cv::BORDER_REPLICATE);
  Image<std::int16_t> result(image.width(), image.height());
  for (int v = 0; v < image.height(); ++v) {
    for (int u = 0; u < image.width(); ++u)
      result(u, v) = static_cast<std::int16_t>(image(u, v) - mean.at<std::uint16_t>(v, u));
  }
  return result;
}

/// Sums of differences over a window, at all disparities, computed row by row.
class WindowCosts {
 public:
  WindowCosts(const Image<std::int16_t>& left, const Image<std::int16_t>& right, int window_px)
      : left_(left),
        right_(right),
        half_(window_px / 2),
        columns_(static_cast<std::size_t>(left.width()) * cost_lanes, 0) {}

  void begin(int v) {
    std::fill(columns_.begin(), columns_.end(), std::uint16_t{0});
    for (int row = v - half_; row <= v + half_; ++row) add_row(row, 1);
  }
  void move_down(int from) {
    add_row(from + half_ + 1, 1);
    add_row(from - half_, -1);
  }
  void write(std::uint16_t* row_costs) const {
    std::uint16_t running[cost_lanes] = {};
    for (int u = -half_; u <= half_; ++u) add(running, column(u), 1);
    for (int u = 0; u < left_.width(); ++u) {
      std::copy(running, running + cost_lanes, row_costs + static_cast<std::ptrdiff_t>(u) * cost_lanes);
      add(running, column(u + half_ + 1), 1);
      add(running, column(u - half_), -1);
    }
  }

 private:
  [[nodiscard]] const std::uint16_t* column(int u) const {
    return &columns_[static_cast<std::size_t>(std::clamp(u, 0, left_.width() - 1)) * cost_lanes];
  }
  static void add(std::uint16_t* sums, const std::uint16_t* more, int sign) {
    for (int d = 0; d < cost_lanes; ++d) sums[d] = static_cast<std::uint16_t>(sums[d] + sign * more[d]);
  }
  void add_row(int row, int sign) {
    const int v = std::clamp(row, 0, left_.height() - 1);
    // Reversed, so that increasing disparities have increasing addresses; outside the image, the first pixel
    // is repeated.
    const int width = left_.width();
    std::vector<std::int16_t> backwards(static_cast<std::size_t>(width) + cost_lanes, right_(0, v));
    for (int u = 0; u < width; ++u) backwards[static_cast<std::size_t>(width - 1 - u)] = right_(u, v);
    for (int u = 0; u < width; ++u) {
      const int mine = left_(u, v);
      const std::int16_t* const others = &backwards[static_cast<std::size_t>(width - 1 - u)];
      std::uint16_t* const sums = &columns_[static_cast<std::size_t>(u) * cost_lanes];
      for (int d = 0; d < cost_lanes; ++d)
        sums[d] = static_cast<std::uint16_t>(sums[d] +
                                             sign * std::min(std::abs(mine - others[d]), most_difference));
    }
  }

  const Image<std::int16_t>& left_;
  const Image<std::int16_t>& right_;
  int half_;
  std::vector<std::uint16_t> columns_;
};

RVA_VECTOR_CLONES
void match_rows(const Image<std::int16_t>& left, const Image<std::int16_t>& right, int window_px,
                const WinnerOptions& winners, int first, int end, Image<std::uint16_t>& disparities) {
  WindowCosts window(left, right, window_px);
  std::vector<std::uint16_t> row_costs(static_cast<std::size_t>(left.width()) * cost_lanes);
  window.begin(first);
  for (int v = first; v < end; ++v) {
    if (v > first) window.move_down(v - 1);
    window.write(row_costs.data());
    choose_winners(row_costs.data(), left.width(), winners, &disparities(0, v));
  }
}

}  // namespace

Image<std::uint16_t> match_by_correlation(const InfraredImage& left, const InfraredImage& right,
                                          const CorrelationOptions& options) {
  assert(left.same_size(right) && options.window_px % 2 == 1 && options.window_px <= 13);
  const Image<std::int16_t> left_band = band_passed(left, options.mean_px);
  const Image<std::int16_t> right_band = band_passed(right, options.mean_px);
  const int least_curvature = static_cast<int>(options.least_texture * options.window_px * options.window_px);
  const WinnerOptions winners{.uniqueness = options.uniqueness, .least_curvature = least_curvature};
  Image<std::uint16_t> disparities(left.width(), left.height(), 0);
  parallel_bands(left.height(), [&](int first, int end) {
    match_rows(left_band, right_band, options.window_px, winners, first, end, disparities);
  });
  return disparities;
}

}  // namespace rva
