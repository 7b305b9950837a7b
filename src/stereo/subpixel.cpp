#include "stereo/subpixel.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <vector>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "core/parallel.hpp"
#include "stereo/weighted_sums.hpp"

namespace rva {

namespace {

constexpr int shifts = 5;      // whole-pixel shifts around the start: -2 to 2
constexpr int border_px = 24;  // on every side, so that no window leaves the image

/// An image with its border pixels repeated outside.
class Bordered {
 public:
  template <typename Value>
  Bordered(int width, int height, Value value) : pixels_(width + 2 * border_px, height + 2 * border_px) {
    parallel_bands(pixels_.height(), [&](int first, int end) {
      for (int row = first; row < end; ++row) {
        const int v = std::clamp(row - border_px, 0, height - 1);
        std::int16_t* const out = &pixels_(border_px, row);
        for (int u = 0; u < width; ++u) out[u] = static_cast<std::int16_t>(value(u, v));
        std::fill_n(&pixels_(0, row), border_px, out[0]);
        std::fill_n(out + width, border_px, out[width - 1]);
      }
    });
  }
  [[nodiscard]] const std::int16_t* at(int u, int v) const { return &pixels_(u + border_px, v + border_px); }

 private:
  Image<std::int16_t> pixels_;
};

#ifdef __SSE2__
/// Weighted sums of the gradient of a window times the right image, at all shifts at once. It is written with
/// intrinsics, since the compiler does not find multiply-and-add in loops as short as a row of a window.
class ProductSums {
 public:
  ProductSums() {
    for (__m128i& sum : sums_) sum = _mm_setzero_si128();
  }
  /// @param weights weights of the row, at most WindowWeights::greatest squared, so that weighted gradients
  ///                fit into 16 bits
  void add_row(const std::int16_t* gradient, const std::int16_t* right, const WindowWeights::Row& weights) {
    const __m128i low = _mm_mullo_epi16(load(gradient), load(weights.data()));
    const __m128i high = _mm_mullo_epi16(load(gradient + 8), load(weights.data() + 8));
    for (int shift = 0; shift < shifts; ++shift) {
      const std::int16_t* const shifted = right + 2 - shift;
      __m128i& sum = sums_[static_cast<std::size_t>(shift)];
      sum = _mm_add_epi32(sum, _mm_madd_epi16(low, load(shifted)));
      sum = _mm_add_epi32(sum, _mm_madd_epi16(high, load(shifted + 8)));
    }
  }
  [[nodiscard]] std::array<std::int32_t, shifts> sums() const {
    std::array<std::int32_t, shifts> totals{};
    for (std::size_t shift = 0; shift < shifts; ++shift) {
      alignas(16) std::array<std::int32_t, 4> quarters{};
      _mm_store_si128(reinterpret_cast<__m128i*>(quarters.data()), sums_[shift]);
      totals[shift] = quarters[0] + quarters[1] + quarters[2] + quarters[3];
    }
    return totals;
  }

 private:
  static __m128i load(const std::int16_t* from) {
    return _mm_loadu_si128(reinterpret_cast<const __m128i*>(from));
  }
  __m128i sums_[shifts];
};
#else
/// The same sums for other processors.
class ProductSums {
 public:
  void add_row(const std::int16_t* gradient, const std::int16_t* right, const WindowWeights::Row& weights) {
    for (int shift = 0; shift < shifts; ++shift) {
      for (int i = 0; i < WindowWeights::lanes; ++i)
        sums_[static_cast<std::size_t>(shift)] +=
            weights[static_cast<std::size_t>(i)] * gradient[i] * right[2 - shift + i];
    }
  }
  [[nodiscard]] const std::array<std::int32_t, shifts>& sums() const { return sums_; }

 private:
  std::array<std::int32_t, shifts> sums_{};
};
#endif

/// Sums over a window of both images, at five shifts around a disparity.
struct WindowPair {
  std::array<std::int32_t, shifts> gradient_right;  // sum of the left gradient times right
  std::array<std::int32_t, shifts> right;
  std::int32_t gradient;
  std::int32_t gradient_gradient;
  std::int32_t gradient_left;
  std::int32_t left;
};

class WindowPairs {
 public:
  WindowPairs(const InfraredImage& left, const InfraredImage& right, const WindowWeights& weights)
      : WindowPairs(left, right, weights, [&left](int u, int v) {
          return left(std::min(u + 1, left.width() - 1), v) - left(std::max(u - 1, 0), v);
        }) {}

  [[nodiscard]] WindowPair at(int u, int v, int disparity) const {
    WindowPair pair{};
    ProductSums products;
    for (int i = 0; i < weights_.window_px; ++i) {
      const int row = v - weights_.half_px + i;
      products.add_row(gradient_.at(u - weights_.half_px, row),
                       right_.at(u - weights_.half_px - disparity, row),
                       weights_.rows[static_cast<std::size_t>(i)]);
    }
    pair.gradient_right = products.sums();
    for (int shift = 0; shift < shifts; ++shift)
      pair.right[static_cast<std::size_t>(shift)] = right_sums_(u - disparity + 2 - shift, v);
    pair.gradient = gradient_sums_(u, v);
    pair.gradient_gradient = gradient_gradient_sums_(u, v);
    pair.gradient_left = gradient_left_sums_(u, v);
    pair.left = left_sums_(u, v);
    return pair;
  }

 private:
  template <typename Gradient>
  WindowPairs(const InfraredImage& left, const InfraredImage& right, const WindowWeights& weights,
              Gradient gradient)
      : weights_(weights),
        gradient_(left.width(), left.height(), gradient),
        right_(right.width(), right.height(), [&](int u, int v) { return right(u, v); }),
        gradient_sums_(left.width(), left.height(), weights, gradient),
        gradient_gradient_sums_(left.width(), left.height(), weights,
                                [&](int u, int v) { return gradient(u, v) * gradient(u, v); }),
        gradient_left_sums_(left.width(), left.height(), weights,
                            [&](int u, int v) { return gradient(u, v) * left(u, v); }),
        left_sums_(left.width(), left.height(), weights, [&](int u, int v) { return int{left(u, v)}; }),
        right_sums_(left.width(), left.height(), weights, [&](int u, int v) { return int{right(u, v)}; }) {}

  const WindowWeights& weights_;
  Bordered gradient_;
  Bordered right_;
  WeightedSums gradient_sums_;
  WeightedSums gradient_gradient_sums_;
  WeightedSums gradient_left_sums_;
  WeightedSums left_sums_;
  WeightedSums right_sums_;
};

/// Weights of the whole-pixel shifts -2 to 2 at a shift between -1 and 1 (Keys 1981, a = -0.5).
std::array<double, shifts> cubic_weights(double shift) {
  std::array<double, shifts> weights{};
  const bool negative = shift < 0.0;
  const double t = negative ? shift + 1.0 : shift;
  const std::size_t first = negative ? 0 : 1;  // index of the first of the four samples
  weights[first] = t * (-0.5 + t * (1.0 - 0.5 * t));
  weights[first + 1] = 1.0 + t * t * (-2.5 + 1.5 * t);
  weights[first + 2] = t * (0.5 + t * (2.0 - 1.5 * t));
  weights[first + 3] = t * t * (-0.5 + 0.5 * t);
  return weights;
}

constexpr double settled_px = 1.0 / 256.0;  // an eighth of the step to which the result is rounded

/// Finds the shift, -1 to 1, at which the right window matches the left one; NaN if it leaves that range.
/// Each Gauss-Newton step divides the sum of the gradient times the difference of the windows, without their
/// means, by the sum of the squared gradient (`curvature`).
double best_shift(const WindowPair& sums, int steps, double mean_gradient, double curvature) {
  const double constant = sums.gradient_left - mean_gradient * sums.left;
  double shift = 0.0;
  for (int step = 0; step < steps; ++step) {
    const std::array<double, shifts> weights = cubic_weights(shift);
    double slope = -constant;
    for (std::size_t i = 0; i < shifts; ++i)
      slope += weights[i] * (sums.gradient_right[i] - mean_gradient * sums.right[i]);
    const double move = 2.0 * slope / curvature;  // the gradient is a difference over two pixels
    shift += move;
    if (!(std::abs(shift) <= 1.0)) return NAN;
    if (std::abs(move) < settled_px) break;
  }
  return shift;
}

double refine(const WindowPair& sums, int disparity, double total_weight, const SubpixelOptions& options) {
  const double mean_gradient = sums.gradient / total_weight;
  const double curvature = sums.gradient_gradient - mean_gradient * sums.gradient;
  // The gradient is a difference over two pixels, so its square is four times that of the gradient per pixel.
  if (curvature / total_weight < 4.0 * options.least_texture * options.least_texture) return NAN;
  return disparity + best_shift(sums, options.steps, mean_gradient, curvature);
}

}  // namespace

Image<std::uint16_t> refine_disparity(const InfraredImage& left, const InfraredImage& right,
                                      const Image<std::uint8_t>& whole, const SubpixelOptions& options) {
  assert(left.same_size(right) && left.same_size(whole) && options.window_px % 2 == 1 &&
         options.window_px <= WindowWeights::most_px);
  const WindowWeights weights(options.window_px);
  const WindowPairs windows(left, right, weights);
  const double total_weight = weights.total();
  const double steps_per_px = std::ldexp(1.0, options.fraction_bits);
  Image<std::uint16_t> refined(left.width(), left.height(), 0);
  parallel_bands(left.height(), [&](int first, int end) {
    for (int v = first; v < end; ++v) {
      for (int u = 0; u < left.width(); ++u) {
        const int disparity = whole(u, v);
        if (disparity == no_match) continue;
        const double exact = refine(windows.at(u, v, disparity), disparity, total_weight, options);
        if (exact > 0.0) refined(u, v) = static_cast<std::uint16_t>(std::lround(exact * steps_per_px));
      }
    }
  });
  return refined;
}

}  // namespace rva
