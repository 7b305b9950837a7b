#include "detect/appearance/color_means.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/quantile.hpp"
#include "depth/mat_view.hpp"
#include "infrared/level.hpp"

namespace rva {
namespace {

// Approximates sRGB, which cameras and displays use, by a power function.
constexpr double gamma = 2.2;
constexpr double most = 255.0;

float linear(std::uint8_t value) {
  static const std::array<float, 256> table = [] {
    std::array<float, 256> values{};
    for (std::size_t i = 0; i < values.size(); ++i)
      values[i] = static_cast<float>(most * std::pow(static_cast<double>(i) / most, gamma));
    return values;
  }();
  return table[value];
}

std::array<Image<float>, 3> linear_channels(const ColorImage& image) {
  std::array<Image<float>, 3> channels;
  channels.fill(Image<float>(image.width(), image.height()));
  for (std::size_t i = 0; i < image.size(); ++i) {
    channels[0][i] = linear(image[i].r);
    channels[1][i] = linear(image[i].g);
    channels[2][i] = linear(image[i].b);
  }
  return channels;
}

Image<float> luminance_of(const std::array<Image<float>, 3>& channels) {
  Image<float> luminance(channels[0].width(), channels[0].height());
  for (std::size_t i = 0; i < luminance.size(); ++i)
    luminance[i] = 0.2126F * channels[0][i] + 0.7152F * channels[1][i] + 0.0722F * channels[2][i];
  return luminance;
}

// Reduces an image to the given size. Both images follow the pixel convention of Intrinsics.
Image<float> reduced(const Image<float>& image, int width, int height) {
  Image<float> result(width, height);
  cv::Mat target = as_mat(result);
  cv::resize(as_mat(image), target, {width, height}, 0.0, 0.0, cv::INTER_AREA);
  return result;
}

Intrinsics reduced(const Intrinsics& camera, int width, int height) {
  const double across = static_cast<double>(width) / camera.width;
  const double down = static_cast<double>(height) / camera.height;
  Intrinsics result = camera;
  result.width = width;
  result.height = height;
  result.fx *= across;
  result.fy *= down;
  result.cx = (camera.cx + 0.5) * across - 0.5;
  result.cy = (camera.cy + 0.5) * down - 0.5;
  return result;
}

/// Sum and range of one channel over the frames.
struct ChannelSums {
  cv::Mat sum;
  cv::Mat least;
  cv::Mat most;

  void add(const Image<float>& light) {
    cv::Mat smooth;
    cv::blur(as_mat(light), smooth, {3, 3});
    if (sum.empty()) {
      sum = as_mat(light).clone();
      least = smooth.clone();
      most = smooth;
    } else {
      sum += as_mat(light);
      least = cv::min(least, smooth);
      most = cv::max(most, smooth);
    }
  }

  // Range of each pixel over time, relative to its brightness.
  [[nodiscard]] cv::Mat range() const {
    constexpr double dark = 3.0;
    return (most - least) / (least + dark);
  }
};

struct FrameSums {
  std::array<ChannelSums, 3> channels;
  int frames = 0;

  void add(const std::array<Image<float>, 3>& light) {
    for (std::size_t c = 0; c < channels.size(); ++c) channels[c].add(light[c]);
    ++frames;
  }

  // Set where a moving object or its shadow changes a pixel by more than noise and flicker do: by a tenth of
  // its light and by six times the change of the median pixel.
  [[nodiscard]] Mask moving() const {
    constexpr double least_share = 0.1;
    constexpr double times_usual = 6.0;
    constexpr int beside_px = 5;
    cv::Mat moving = cv::Mat::zeros(channels[0].sum.size(), CV_8U);
    for (const ChannelSums& channel : channels) {
      const cv::Mat share = channel.range();
      std::vector<float> usual = sampled(share, Mask(share.cols, share.rows, mask_set));
      if (usual.empty()) continue;
      moving |= share > std::max(least_share, times_usual * static_cast<double>(quantile(usual, 0.5)));
    }
    Mask mask(moving.cols, moving.rows);
    cv::Mat target = as_mat(mask);
    cv::dilate(moving, target, cv::Mat::ones(2 * beside_px + 1, 2 * beside_px + 1, CV_8U));
    return mask;
  }

  [[nodiscard]] std::array<Image<float>, 3> means() const {
    std::array<Image<float>, 3> images;
    for (std::size_t c = 0; c < images.size(); ++c) {
      const cv::Mat& sum = channels[c].sum;
      images[c] = Image<float>(sum.cols, sum.rows);
      cv::Mat target = as_mat(images[c]);
      sum.convertTo(target, CV_32F, 1.0 / frames);
    }
    return images;
  }
};

}  // namespace

bool has_comparable_color(const Capture& capture) {
  const CaptureInfo& info = capture.info();
  return capture.color_frames() > 0 && info.color && info.color_from_depth &&
         info.color->distortion == Distortion::none && info.depth.distortion == Distortion::none;
}

std::optional<ColorMeans> color_means(const Capture& capture, int most_frames) {
  const Intrinsics& full = capture.info().color.value();
  const int width = std::min(full.width, capture.info().depth.width);
  const int height = full.height * width / full.width;
  FrameSums sums;
  const auto add_every = [&](std::size_t step) {
    for (std::size_t i = 0; i < capture.depth_frames() && sums.frames < most_frames; i += step) {
      const std::optional<ColorImage> image = capture.color_of(i);
      if (!image) continue;
      std::array<Image<float>, 3> light = linear_channels(*image);
      for (Image<float>& channel : light) channel = reduced(channel, width, height);
      sums.add(light);
    }
  };
  add_every(std::max<std::size_t>(1, capture.depth_frames() / static_cast<std::size_t>(most_frames)));
  if (sums.frames == 0) add_every(1);
  if (sums.frames == 0) return std::nullopt;
  ColorMeans means{reduced(full, width, height), sums.means(), {}, sums.moving()};
  means.luminance = luminance_of(means.channels);
  return means;
}

bool is_well_lit(const ColorMeans& color) {
  constexpr float least = 4.0F;  // of the brighter parts; a closed wing is darker
  constexpr float saturated = 250.0F;
  std::vector<float> levels =
      sampled(as_mat(color.luminance), Mask(color.luminance.width(), color.luminance.height(), mask_set));
  return !levels.empty() && quantile(levels, 0.9) >= least && quantile(levels, 0.6) < saturated;
}

}  // namespace rva
