// Views of known surfaces, with errors of known correlation.
#pragma once

#include <functional>
#include <numeric>
#include <vector>

#include "core/random.hpp"
#include "measure/uncertain_view.hpp"

namespace rva::test {

inline constexpr int view_width = 160;
inline constexpr int view_height = 120;

/// The depth along z of the surface that a ray (x, y, 1) meets, metres; 0 for no measurement.
using Surface = std::function<double(const Eigen::Vector3d& ray)>;

/// The plane of all points P with n . P = 1.
inline Surface plane(const Eigen::Vector3d& n) {
  return [n](const Eigen::Vector3d& ray) { return 1.0 / n.dot(ray); };
}

/// The view of a surface without errors, but with their uncertainty stated.
inline UncertainView view_of(const Surface& surface, double uncertainty_px = 0.06) {
  UncertainView view{{view_width, view_height, 200.0, 200.0, 79.5, 59.5},
                     {200.0 * 0.05, 0.001},
                     Image<float>(view_width, view_height),
                     Image<float>(view_width, view_height),
                     11.0};
  for (int v = 0; v < view_height; ++v) {
    for (int u = 0; u < view_width; ++u) {
      const double depth_m = surface(view.ray({u, v}));
      if (depth_m <= 0.0) continue;
      view.disparity_px(u, v) = static_cast<float>(view.stereo.disparity_px(depth_m));
      view.uncertainty_px(u, v) = static_cast<float>(uncertainty_px);
    }
  }
  return view;
}

/// White noise summed over a matcher's window: its correlation is that of equation 76, exactly.
inline Image<float> matching_error(Random& random, double deviation_px, int window_px = 11) {
  const int width = view_width + window_px;
  const int height = view_height + window_px;
  std::vector<double> sums(static_cast<std::size_t>(width + 1) * static_cast<std::size_t>(height + 1), 0.0);
  const auto at = [&](int u, int v) -> double& {
    return sums[static_cast<std::size_t>(v) * static_cast<std::size_t>(width + 1) +
                static_cast<std::size_t>(u)];
  };
  for (int v = 0; v < height; ++v) {
    for (int u = 0; u < width; ++u)
      at(u + 1, v + 1) = random.normal() + at(u, v + 1) + at(u + 1, v) - at(u, v);
  }
  Image<float> error(view_width, view_height);
  for (int v = 0; v < view_height; ++v) {
    for (int u = 0; u < view_width; ++u) {
      const double sum =
          at(u + window_px, v + window_px) - at(u, v + window_px) - at(u + window_px, v) + at(u, v);
      error(u, v) = static_cast<float>(deviation_px * sum / window_px);
    }
  }
  return error;
}

/// Adds an error to each disparity that was measured.
inline void add(UncertainView& view, const Image<float>& error) {
  for (std::size_t i = 0; i < error.size(); ++i) {
    if (view.disparity_px[i] > 0.0F) view.disparity_px[i] += error[i];
  }
}

/// A rectangle of a view, as a region.
inline Mask rectangle(int left, int top, int width, int height) {
  Mask mask(view_width, view_height);
  for (int v = top; v < top + height; ++v) {
    for (int u = left; u < left + width; ++u) mask(u, v) = mask_set;
  }
  return mask;
}

}  // namespace rva::test
