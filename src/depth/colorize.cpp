#include "depth/colorize.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <opencv2/imgproc.hpp>
#include <string>
#include <utility>
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

// The darkest colours at the ends of turbo are left out.
constexpr double first_of_turbo = 20.0;
constexpr double last_of_turbo = 245.0;

ColorImage colors_of(Image<std::uint8_t> levels, ColorMap map) {
  cv::Mat scaled = as_mat(levels);
  if (map == ColorMap::turbo)
    scaled.convertTo(scaled, CV_8U, (last_of_turbo - first_of_turbo) / 255.0, first_of_turbo);
  cv::Mat bgr;
  cv::applyColorMap(scaled, bgr, map == ColorMap::turbo ? cv::COLORMAP_TURBO : cv::COLORMAP_JET);
  ColorImage image(levels.width(), levels.height());
  cv::cvtColor(bgr, as_mat(image), cv::COLOR_BGR2RGB);
  return image;
}

// Round values from low to high, both included where they are round.
std::vector<float> ticks_of(ColorScale scale) {
  constexpr float most = 6.0F;
  const float step = round_step((scale.high - scale.low) / most);
  const float tolerance = 1e-3F * step;
  std::vector<float> ticks;
  for (float tick = std::ceil((scale.low - tolerance) / step); tick * step <= scale.high + tolerance;
       tick += 1.0F)
    ticks.push_back(tick * step + 0.0F);  // no -0
  return ticks;
}

std::vector<std::string> lines_of(std::string_view text) {
  std::vector<std::string> lines;
  for (std::size_t start = 0; start <= text.size();) {
    const std::size_t end = std::min(text.find('\n', start), text.size());
    lines.emplace_back(text.substr(start, end - start));
    start = end + 1;
  }
  return lines;
}

/// The places of a legend beside an image. They follow the image's height, so that the legend reads the same
/// beside any camera's image, down to the least that can be read.
struct LegendLayout {
  LegendLayout(const ColorImage& image, const std::vector<std::string>& title,
               const std::vector<std::string>& labels)
      : font(std::max(0.4, image.height() / 900.0)),
        margin(std::max(6, image.height() / 40)),
        line_height(static_cast<int>(38.0 * font)),
        bar_width(std::max(12, image.height() / 20)),
        left(image.width() + margin),
        bar_top(margin + line_height * static_cast<int>(title.size()) + line_height / 2) {
    constexpr int least_bar_height = 90;  // room for the labels beside an image of a few rows
    bar_height = std::max(least_bar_height, image.height() - bar_top - margin - line_height / 2);
    const int beside_bar = bar_width + margin + widest(labels);
    width = left + std::max(beside_bar, widest(title)) + margin;
    height = std::max(image.height(), bar_top + bar_height + line_height / 2 + margin);
  }

  [[nodiscard]] int widest(const std::vector<std::string>& texts) const {
    int most = 0;
    for (const std::string& text : texts) {
      int below = 0;
      most = std::max(most, cv::getTextSize(text, cv::FONT_HERSHEY_SIMPLEX, font, 1, &below).width);
    }
    return most;
  }

  double font;
  int margin;
  int line_height;
  int bar_width;
  int left;  ///< of title and bar
  int bar_top;
  int bar_height = 0;
  int width = 0;  ///< of the whole picture
  int height = 0;
};

ColorImage bar_of(const LegendLayout& layout, ColorMap map) {
  Image<std::uint8_t> ramp(layout.bar_width, layout.bar_height);
  for (int v = 0; v < layout.bar_height; ++v) {
    for (int u = 0; u < layout.bar_width; ++u)
      ramp(u, v) = static_cast<std::uint8_t>(255 - 255 * v / std::max(1, layout.bar_height - 1));
  }
  return colors_of(std::move(ramp), map);
}

}  // namespace

ColorImage colorize(const Image<float>& values, ColorScale scale, ColorMap map) {
  Image<std::uint8_t> levels(values.width(), values.height());
  for (std::size_t i = 0; i < values.size(); ++i) {
    levels[i] = std::isnan(values[i]) ? std::uint8_t{0} : level_of(values[i], scale);
  }
  ColorImage image = colors_of(std::move(levels), map);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (std::isnan(values[i])) image[i] = Rgb{};
  }
  return image;
}

ColorImage with_legend(const ColorImage& image, ColorScale scale, std::string_view title, ColorMap map) {
  const std::vector<std::string> lines = lines_of(title);
  const std::vector<float> ticks = ticks_of(scale);
  std::vector<std::string> labels;
  for (const float tick : ticks) labels.push_back(fmt::format("{:.4g}", tick));
  const LegendLayout layout(image, lines, labels);
  ColorImage canvas(layout.width, layout.height, Rgb{255, 255, 255});
  cv::Mat picture = as_mat(canvas);
  as_mat(image).copyTo(picture(cv::Rect(0, 0, image.width(), image.height())));
  const cv::Rect bar(layout.left, layout.bar_top, layout.bar_width, layout.bar_height);
  as_mat(bar_of(layout, map)).copyTo(picture(bar));

  const cv::Scalar black(0, 0, 0);
  const auto write = [&](const std::string& text, const cv::Point& at) {
    cv::putText(picture, text, at, cv::FONT_HERSHEY_SIMPLEX, layout.font, black, 1, cv::LINE_AA);
  };
  for (std::size_t k = 0; k < lines.size(); ++k)
    write(lines[k], {layout.left,
                     layout.margin + layout.line_height * static_cast<int>(k + 1) - layout.line_height / 4});
  for (std::size_t k = 0; k < ticks.size(); ++k) {
    const float share = (scale.high - ticks[k]) / (scale.high - scale.low);
    const int v = bar.y + static_cast<int>(std::lround(share * static_cast<float>(bar.height - 1)));
    cv::line(picture, {bar.br().x, v}, {bar.br().x + layout.margin / 2, v}, black, 1);
    write(labels[k], {bar.br().x + layout.margin, v + layout.line_height / 4});
  }
  return canvas;
}

ColorScale scale_from_zero(const Image<float>& values) {
  std::vector<float> finite = finite_values(values);
  const float high = finite.empty() ? 0.0F : quantile(finite, 0.9);
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

}  // namespace rva
