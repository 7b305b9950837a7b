#include "stereo/plane_sweep.hpp"

#include <algorithm>
#include <cassert>
#include <cmath>

#include "core/interrupt.hpp"
#include "core/parallel.hpp"
#include "core/quantile.hpp"
#include "core/vector_clones.hpp"

namespace rva {
namespace {

int labels_of(const SweepOptions& options) {
  return 2 * static_cast<int>(std::lround(options.range_px / options.step_px)) + 1;
}

/// Differences between the left and the right image of one view at all labels, along one row of
/// the reference.
class RowDifferences {
 public:
  RowDifferences(const ReferenceSurface& start, const StereoScale& stereo, const StereoView& view,
                 const SweepOptions& options)
      : start_(start),
        view_(view),
        where_(start, view.view_from_reference),
        labels_(labels_of(options)),
        per_px_(static_cast<int>(std::lround(1.0 / options.step_px))),
        range_px_(static_cast<float>(options.range_px)),
        excess_px_(static_cast<float>(view.excess_px)),
        focal_baseline_m_px_(static_cast<float>(stereo.focal_baseline_m_px)) {
    const Transform& pose = view.view_from_reference;
    depth_of_ray_ = pose.linear().row(2).cast<float>();
    depth_shift_ = static_cast<float>(pose.translation().z());
    const int columns = (labels_ - 1) / per_px_ + 2;
    segment_.resize(static_cast<std::size_t>(columns) + 4);
  }

  /// @param differences `labels` numbers per pixel; 0 if the view does not see the pixel
  /// @param seen        1 if the view sees the pixel at every label, else 0
  void row(int v, float* differences, float* seen) {
    const int width = start_.inverse_depth_per_m.width();
    for (int u = 0; u < width; ++u, differences += labels_, ++seen) {
      *seen = differences_at(u, v, differences) ? 1.0F : 0.0F;
      if (*seen == 0.0F) std::fill_n(differences, labels_, 0.0F);
    }
  }

 private:
  // The disparity in the view of the surface point at a pixel of the reference.
  [[nodiscard]] float disparity_of(int u, int v) const {
    const Intrinsics& camera = start_.camera;
    const float inverse = start_.inverse_depth_per_m(u, v);
    const Eigen::Vector3f ray(
        (static_cast<float>(u) - static_cast<float>(camera.cx)) / static_cast<float>(camera.fx),
        (static_cast<float>(v) - static_cast<float>(camera.cy)) / static_cast<float>(camera.fy), 1.0F);
    return focal_baseline_m_px_ * inverse / (depth_of_ray_.dot(ray) + depth_shift_ * inverse);
  }

  RVA_VECTOR_CLONES bool differences_at(int u, int v, float* differences) {
    const Eigen::Vector2f at = where_.seen_at(u, v);
    const Image<float>& right = view_.right;
    // The column of the largest disparity, which is farthest to the left.
    const float first_u = at.x() - disparity_of(u, v) - excess_px_ - range_px_;
    const int top = static_cast<int>(std::floor(at.y()));
    const int left = static_cast<int>(std::floor(first_u));
    const int columns = static_cast<int>(segment_.size());
    if (top < 1 || top + 2 >= right.height() || left < 1 || left - 1 + columns > right.width() ||
        at.x() < 0.0F || at.x() > static_cast<float>(right.width() - 1))
      return false;
    const Eigen::Array4f down = cubic_weights(at.y() - static_cast<float>(top));
    const float* pixels = &right(left - 1, top - 1);
    std::fill(segment_.begin(), segment_.end(), 0.0F);
    for (const float weight : down) {
      for (int i = 0; i < columns; ++i) segment_[static_cast<std::size_t>(i)] += weight * pixels[i];
      pixels += right.width();
    }
    const float seen = cubic_at(view_.left, at);
    const float fraction = first_u - static_cast<float>(left);
    for (int phase = 0; phase < per_px_; ++phase) {
      const float shifted = fraction + static_cast<float>(phase) / static_cast<float>(per_px_);
      const int whole = static_cast<int>(shifted);
      const Eigen::Array4f across = cubic_weights(shifted - static_cast<float>(whole));
      const float* samples = segment_.data() + whole;
      // The first sample is farthest to the left and belongs to the last label.
      for (int label = labels_ - 1 - phase; label >= 0; label -= per_px_, ++samples)
        differences[label] = seen - (across[0] * samples[0] + across[1] * samples[1] +
                                     across[2] * samples[2] + across[3] * samples[3]);
    }
    return true;
  }

  const ReferenceSurface& start_;
  const StereoView& view_;
  ViewOfSurface where_;
  int labels_;
  int per_px_;
  float range_px_;
  float excess_px_;
  float focal_baseline_m_px_;
  Eigen::Vector3f depth_of_ray_;
  float depth_shift_ = 0.0F;
  std::vector<float> segment_;  // of the right image, interpolated at the row of the pixel
};

/// Sums over square windows that slide down the rows of one view: of differences, of their squares, and of
/// their number.
class WindowCosts {
 public:
  WindowCosts(int width, int labels, int window_px)
      : width_(width),
        labels_(labels),
        half_px_(window_px / 2),
        rows_(static_cast<std::size_t>(window_px)),
        sums_(row_size()),
        squares_(row_size()),
        counts_(static_cast<std::size_t>(width)),
        along_(static_cast<std::size_t>(labels)),
        squares_along_(static_cast<std::size_t>(labels)) {
    for (Row& row : rows_) {
      row.differences.resize(row_size());
      row.seen.resize(static_cast<std::size_t>(width));
    }
  }

  /// One row of differences. The next row replaces the oldest one.
  struct Row {
    std::vector<float> differences;
    std::vector<float> seen;
  };
  [[nodiscard]] Row& next() {
    Row& row = rows_[newest_++ % rows_.size()];
    return row;
  }

  /// Adds the costs of the middle row of those given.
  /// Equation 62 of docs/math.md.
  RVA_VECTOR_CLONES void add_to(SweptCosts& costs, int v) {
    sum_columns();
    std::fill(along_.begin(), along_.end(), 0.0F);
    std::fill(squares_along_.begin(), squares_along_.end(), 0.0F);
    float count = 0.0F;
    for (int u = -half_px_; u < width_; ++u) {
      if (u + half_px_ < width_) count += slide(u + half_px_, 1.0F);
      if (u - half_px_ - 1 >= 0) count += slide(u - half_px_ - 1, -1.0F);
      if (u < 0 || count < least_count) continue;
      float* const out = costs.at(u, v).data();
      for (std::size_t i = 0; i < along_.size(); ++i)
        out[i] += std::max(squares_along_[i] - along_[i] * along_[i] / count, 0.0F);
      costs.freedom(u, v) += count - 1.0F;
    }
  }

 private:
  static constexpr float least_count = 1.5F;  // at least two samples

  // Sums from top to bottom regardless of the position in the band, since sums of floating point depend on
  // their order.
  void sum_columns() {
    std::fill(counts_.begin(), counts_.end(), 0.0F);
    for (const Row& row : rows_) {
      for (std::size_t u = 0; u < counts_.size(); ++u) counts_[u] += row.seen[u];
    }
    constexpr std::size_t few = 64;  // so that they stay in the nearest cache while all rows are added
    for (std::size_t first = 0; first < sums_.size(); first += few)
      sum_rows(first, std::min(few, sums_.size() - first));
  }

  void sum_rows(std::size_t first, std::size_t count) {
    float* const sums = sums_.data() + first;
    float* const squares = squares_.data() + first;
    std::fill_n(sums, count, 0.0F);
    std::fill_n(squares, count, 0.0F);
    for (std::size_t k = 0; k < rows_.size(); ++k) {
      const float* const differences = rows_[(newest_ + k) % rows_.size()].differences.data() + first;
      for (std::size_t i = 0; i < count; ++i) {
        sums[i] += differences[i];
        squares[i] += differences[i] * differences[i];
      }
    }
  }

  [[nodiscard]] std::size_t row_size() const {
    return static_cast<std::size_t>(width_) * static_cast<std::size_t>(labels_);
  }

  float slide(int column, float sign) {
    const auto u = static_cast<std::size_t>(column);
    const float* const sums = sums_.data() + u * along_.size();
    const float* const squares = squares_.data() + u * along_.size();
    for (std::size_t i = 0; i < along_.size(); ++i) {
      along_[i] += sign * sums[i];
      squares_along_[i] += sign * squares[i];
    }
    return sign * counts_[u];
  }

  int width_;
  int labels_;
  int half_px_;
  std::size_t newest_ = 0;
  std::vector<Row> rows_;
  std::vector<float> sums_;
  std::vector<float> squares_;
  std::vector<float> counts_;
  std::vector<float> along_;
  std::vector<float> squares_along_;
};

struct Rows {
  int first;
  int end;
};

// Adds the costs of one view. Rows outside the image do not contribute. `costs` may consist of these
// rows only.
void add_view(const ReferenceSurface& start, const StereoScale& stereo, const StereoView& view,
              const SweepOptions& options, const Rows& rows, SweptCosts& costs) {
  RowDifferences differences(start, stereo, view, options);
  WindowCosts windows(start.inverse_depth_per_m.width(), costs.labels(), options.window_px);
  const int half_px = options.window_px / 2;
  const int height = start.inverse_depth_per_m.height();
  const int first_of_costs = costs.freedom.height() == height ? 0 : rows.first;
  for (int v = rows.first - half_px; v < rows.end + half_px; ++v) {
    WindowCosts::Row& row = windows.next();
    if (v >= 0 && v < height) {
      differences.row(v, row.differences.data(), row.seen.data());
    } else {
      std::fill(row.differences.begin(), row.differences.end(), 0.0F);
      std::fill(row.seen.begin(), row.seen.end(), 0.0F);
    }
    if (v - half_px >= rows.first) windows.add_to(costs, v - half_px - first_of_costs);
  }
}

// Appends the disparity of the least cost of each pixel.
void add_best(const SweptCosts& costs, std::vector<float>& best_px) {
  for (int v = 0; v < costs.freedom.height(); ++v) {
    for (int u = 0; u < costs.freedom.width(); ++u) {
      if (costs.freedom(u, v) > 0.0F) best_px.push_back(costs.offset_px(minimum_of(costs.at(u, v)).label));
    }
  }
}

// The median over strips of rows, which are a sufficient sample.
float excess_px(const ReferenceSurface& surface, const StereoScale& stereo, const StereoView& view) {
  constexpr SweepOptions labels{.window_px = 9, .range_px = 1.5, .step_px = 0.25};
  constexpr int strip_px = 4;
  constexpr int every_px = 32;
  std::vector<float> best_px;
  for (int top = every_px / 2; top + strip_px <= surface.inverse_depth_per_m.height(); top += every_px) {
    SweptCosts costs(surface.inverse_depth_per_m.width(), strip_px, labels);
    add_view(surface, stereo, view, labels, {top, top + strip_px}, costs);
    add_best(costs, best_px);
  }
  return best_px.empty() ? 0.0F : quantile(best_px, 0.5);
}

}  // namespace

SweptCosts::SweptCosts(int width, int height, const SweepOptions& options)
    : freedom(width, height),
      labels_(labels_of(options)),
      first_px_(static_cast<float>(-options.range_px)),
      step_px_(static_cast<float>(options.step_px)),
      costs_(freedom.size() * static_cast<std::size_t>(labels_)) {}

SweptCosts sweep(const ReferenceSurface& start, const StereoScale& stereo, std::span<const StereoView> views,
                 const SweepOptions& options) {
  assert(options.window_px % 2 == 1);
  SweptCosts costs(start.inverse_depth_per_m.width(), start.inverse_depth_per_m.height(), options);
  parallel_bands(start.inverse_depth_per_m.height(), [&](int first, int end) {
    for (const StereoView& view : views) {
      throw_if_interrupted();
      add_view(start, stereo, view, options, {first, end}, costs);
    }
  });
  return costs;
}

void align_disparities(const ReferenceSurface& surface, const StereoScale& stereo,
                       std::span<StereoView> views) {
  parallel_bands(static_cast<int>(views.size()), [&](int first, int end) {
    for (int k = first; k < end; ++k) {
      throw_if_interrupted();
      StereoView& view = views[static_cast<std::size_t>(k)];
      view.excess_px += static_cast<double>(excess_px(surface, stereo, view));
    }
  });
}

// Equation 64 of docs/math.md.
Minimum minimum_of(std::span<const float> costs) {
  const auto least = std::ranges::min_element(costs);
  const auto label = static_cast<float>(least - costs.begin());
  if (least == costs.begin() || least + 1 == costs.end()) return {label, *least};
  const float before = *(least - 1);
  const float after = *(least + 1);
  const float curvature = before - 2.0F * *least + after;
  if (curvature <= 0.0F) return {label, *least};
  const float shift = 0.5F * (before - after) / curvature;
  return {label + shift, std::max(*least - 0.25F * (before - after) * shift, 0.0F), 0.5F * curvature};
}

}  // namespace rva
