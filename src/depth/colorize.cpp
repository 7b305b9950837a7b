#include "depth/colorize.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <string>
#include <vector>

#include "core/quantile.hpp"
#include "depth/mat_view.hpp"

namespace rva {
namespace {

// The smallest of 1, 2, 2.5, 5 and 10 times a power of ten that is at least the value.
float round_step(float value) {
  const float power = std::pow(10.0F, std::floor(std::log10(value)));
  for (const float factor : {1.0F, 2.0F, 2.5F, 5.0F}) {
    if (factor * power >= value * 0.9999F) return factor * power;
  }
  return 10.0F * power;
}

// The number of intervals between the labels of the bar, chosen so that the labels are round numbers.
int bar_intervals(ColorScale scale) {
  for (const int intervals : {5, 4}) {
    const float step = (scale.high - scale.low) / static_cast<float>(intervals);
    if (round_step(step) < step * 1.001F) return intervals;
  }
  return 5;
}

std::vector<float> finite_values(const Image<float>& values) {
  std::vector<float> finite;
  finite.reserve(values.size());
  std::ranges::copy_if(values.pixels(), std::back_inserter(finite),
                       [](float value) { return std::isfinite(value); });
  return finite;
}

// Index of a value in the colour map, 0 to 255.
std::uint8_t level_of(float value, ColorScale scale) {
  const float share = (value - scale.low) / (scale.high - scale.low);
  return static_cast<std::uint8_t>(std::lround(255.0F * std::clamp(share, 0.0F, 1.0F)));
}

ColorImage jet(const Image<std::uint8_t>& levels) {
  cv::Mat bgr;
  cv::applyColorMap(as_mat(levels), bgr, cv::COLORMAP_JET);
  ColorImage image(levels.width(), levels.height());
  cv::cvtColor(bgr, as_mat(image), cv::COLOR_BGR2RGB);
  return image;
}

}  // namespace

ColorImage colorize(const Image<float>& values, ColorScale scale) {
  Image<std::uint8_t> levels(values.width(), values.height());
  for (std::size_t i = 0; i < values.size(); ++i) {
    levels[i] = std::isnan(values[i]) ? std::uint8_t{0} : level_of(values[i], scale);
  }
  ColorImage image = jet(levels);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(values[i])) image[i] = Rgb{};
  }
  return image;
}

ColorImage with_scale_bar(const ColorImage& image, ColorScale scale, std::string_view title) {
  // Sizes follow the image's height, so that the bar reads the same beside any camera's image.
  const double font = std::max(0.3, image.height() / 900.0);
  const int margin = std::max(4, image.height() / 40);
  const int bar_width = std::max(8, image.height() / 20);
  const int text_width = static_cast<int>(130.0 * font);
  const int title_height = static_cast<int>(46.0 * font);
  const int bar_top = margin + title_height;
  constexpr int least_bar_height = 60;  // room for the labels beside an image of a few rows
  const int bar_height = std::max(least_bar_height, image.height() - bar_top - margin);

  ColorImage canvas(image.width() + 2 * margin + bar_width + text_width,
                    std::max(image.height(), bar_top + bar_height + margin), Rgb{255, 255, 255});
  cv::Mat picture = as_mat(canvas);
  as_mat(image).copyTo(picture(cv::Rect(0, 0, image.width(), image.height())));

  Image<std::uint8_t> ramp(bar_width, bar_height);
  for (int v = 0; v < bar_height; ++v) {
    for (int u = 0; u < bar_width; ++u)
      ramp(u, v) = static_cast<std::uint8_t>(255 - 255 * v / std::max(1, bar_height - 1));
  }
  const int left = image.width() + margin;
  as_mat(jet(ramp)).copyTo(picture(cv::Rect(left, bar_top, bar_width, bar_height)));

  const cv::Scalar black(0, 0, 0);
  const auto write = [&](const std::string& text, int u, int v) {
    cv::putText(picture, text, {u, v}, cv::FONT_HERSHEY_SIMPLEX, font, black, 1, cv::LINE_AA);
  };
  write(std::string(title), left, margin + static_cast<int>(22.0 * font));
  const int intervals = bar_intervals(scale);
  for (int k = 0; k <= intervals; ++k) {
    const float share = static_cast<float>(k) / static_cast<float>(intervals);
    const float value = scale.low + share * (scale.high - scale.low);
    const int v = bar_top + static_cast<int>((1.0F - share) * static_cast<float>(bar_height - 1));
    cv::line(picture, {left + bar_width, v}, {left + bar_width + margin / 2, v}, black, 1);
    write(fmt::format("{:.4g}", value), left + bar_width + margin, v + static_cast<int>(8.0 * font));
  }
  return canvas;
}

ColorScale scale_from_zero(const Image<float>& values) {
  std::vector<float> finite = finite_values(values);
  const float high = finite.empty() ? 0.0F : quantile(finite, 0.95);
  return {0.0F, high > 0.0F ? round_step(high) : 1.0F};
}

ColorScale scale_of_depth(const Image<float>& depth_m) {
  std::vector<float> measured = finite_values(depth_m);
  if (measured.empty()) return {};
  constexpr float step_m = 0.1F;
  const float low_m = std::floor(quantile(measured, 0.02) / step_m) * step_m;
  const float high_m = std::ceil(quantile(measured, 0.9) / step_m) * step_m;
  return {low_m, std::max(high_m, low_m + step_m)};
}

ColorScale scale_around(const Image<float>& values) {
  std::vector<float> finite = finite_values(values);
  if (finite.empty()) return {};
  const float low = quantile(finite, 0.01);
  const float high = quantile(finite, 0.99);
  // At least a thousandth of the value, so that the ends differ in single precision.
  const float step = round_step(std::max({high - low, 1e-3F, 1e-3F * std::abs(high)}) / 8.0F);
  return {std::floor(low / step) * step, std::floor(high / step + 1.0F) * step};
}

}  // namespace rva
