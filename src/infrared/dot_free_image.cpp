#include "infrared/dot_free_image.hpp"

#include <algorithm>
#include <opencv2/imgproc.hpp>
#include <utility>

#include "depth/mat_view.hpp"
#include "infrared/dot_mask.hpp"
#include "infrared/gaps.hpp"
#include "infrared/projector_field.hpp"

namespace rva {
namespace {

cv::Mat window_sum(const Image<float>& values, int window_px) {
  cv::Mat sums;
  cv::boxFilter(as_mat(values), sums, CV_32F, {window_px, window_px}, {-1, -1}, false, cv::BORDER_REFLECT);
  return sums;
}

/// Sums over the views for each pixel.
struct Samples {
  Samples(int width, int height) : sum(width, height), squares(width, height), count(width, height) {}

  void add(const Image<float>& values, const Mask& clear) {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (clear[i] == 0) continue;
      sum[i] += values[i];
      squares[i] += values[i] * values[i];
      ++count[i];
    }
  }
  // The variance of a single sample, from the differences between the samples of each pixel in a window.
  [[nodiscard]] Image<float> variance() const {
    constexpr int window_px = 9;
    constexpr float least_differences = 16.0F;  // of the 81 pixels of the window
    Image<float> about_mean(sum.width(), sum.height());
    Image<float> freedom(sum.width(), sum.height());
    for (std::size_t i = 0; i < sum.size(); ++i) {
      const auto n = static_cast<float>(count[i]);
      if (n < 2.0F) continue;
      about_mean[i] = std::max(squares[i] - sum[i] * sum[i] / n, 0.0F);
      freedom[i] = n - 1.0F;
    }
    const cv::Mat squares_around = window_sum(about_mean, window_px);
    const cv::Mat freedom_around = window_sum(freedom, window_px);
    Image<float> variance(sum.width(), sum.height());
    for (std::size_t i = 0; i < sum.size(); ++i) {
      const float differences = freedom_around.ptr<float>()[i];
      if (differences >= least_differences) variance[i] = squares_around.ptr<float>()[i] / differences;
    }
    return variance;
  }

  Image<float> sum;
  Image<float> squares;
  Image<std::uint8_t> count;
};

// Pixels in which brightness is clipped, so that an object may not show.
Mask saturated_pixels(const Image<float>& grey) {
  constexpr float brightest = 250.0F;
  Mask mask(grey.width(), grey.height());
  for (std::size_t i = 0; i < grey.size(); ++i) {
    if (grey[i] > brightest) mask[i] = mask_set;
  }
  return mask;
}

// Pixels to which hardly any light of the lamp returns. They show the black level of the imager, which does
// not depend on exposure and would change when images are scaled to one level.
Mask without_light(const Image<float>& grey) {
  constexpr float least_grey = 3.0F;
  Mask mask(grey.width(), grey.height());
  for (std::size_t i = 0; i < grey.size(); ++i) {
    if (grey[i] < least_grey) mask[i] = mask_set;
  }
  return mask;
}

Mask either_set(Mask a, const Mask& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] |= b[i];
  return a;
}

}  // namespace

InfraredView::InfraredView(const Image<float>& grey, const Transform& pose, Light light, float scale)
    : log_image(log_grey(grey, scale)),
      saturated(saturated_pixels(grey)),
      dots(light == Light::projector ? dot_mask(log_image) : either_set(saturated, without_light(grey))),
      view_from_reference(pose) {}

// Equation 55 of docs/math.md.
DotFreeImage fuse(const ReferenceSurface& surface, std::span<const InfraredView> views) {
  const int width = surface.inverse_depth_per_m.width();
  const int height = surface.inverse_depth_per_m.height();
  Samples samples(width, height);
  for (const InfraredView& view : views) {
    const Warp warp = view.warp_from(surface);
    samples.add(warp.image(view.log_image), warp.clear_of(view.dots));
  }
  DotFreeImage fused{Image<float>(width, height), samples.variance(), std::move(samples.count)};
  for (std::size_t i = 0; i < fused.samples.size(); ++i) {
    const auto n = static_cast<float>(fused.samples[i]);
    fused.log_image[i] = n > 0.0F ? samples.sum[i] / n : 0.0F;
    fused.variance[i] = n > 0.0F ? fused.variance[i] / n : 0.0F;
  }
  return fused;
}

Image<float> without_gaps(const DotFreeImage& image) {
  Image<float> filled = image.log_image;
  fill_gaps(as_mat(image.samples) == 0, filled);
  return filled;
}

Mask both_set(Mask a, const Mask& b) {
  for (std::size_t i = 0; i < a.size(); ++i) a[i] &= b[i];
  return a;
}

Mask seen_in_all(const ReferenceSurface& surface, std::span<const InfraredView> views) {
  constexpr float within_image_px = 6.0F;
  const int width = surface.inverse_depth_per_m.width();
  const int height = surface.inverse_depth_per_m.height();
  Mask seen(width, height, mask_set);
  for (const InfraredView& view : views) {
    const Warp warp = view.warp_from(surface);
    for (int v = 0; v < height; ++v) {
      for (int u = 0; u < width; ++u) {
        if (!warp.inside(u, v, within_image_px)) seen(u, v) = 0;
      }
    }
  }
  return seen;
}

Mask lit_in_all(const ReferenceSurface& surface, std::span<const InfraredView> views) {
  Mask lit = seen_in_all(surface, views);
  for (const InfraredView& view : views) {
    const Warp warp = view.warp_from(surface);
    const Mask clear = warp.clear_of(without_dots(view.dots));
    for (std::size_t i = 0; i < lit.size(); ++i) {
      if (clear[i] == 0) lit[i] = 0;
    }
  }
  return lit;
}

Mask within_projectors(const ReferenceSurface& surface, std::span<const InfraredView> views) {
  Mask within(surface.inverse_depth_per_m.width(), surface.inverse_depth_per_m.height(), mask_set);
  for (const InfraredView& view : views) {
    const Warp warp = view.warp_from(surface);
    const Mask clear = warp.clear_of(beyond_projector(view.log_image, view.dots, beside_field_px));
    for (int v = 0; v < within.height(); ++v) {
      for (int u = 0; u < within.width(); ++u) {
        if (clear(u, v) == 0 && warp.inside(u, v, 1.0F)) within(u, v) = 0;
      }
    }
  }
  return within;
}

}  // namespace rva
