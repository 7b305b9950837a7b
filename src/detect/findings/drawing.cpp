#include "detect/findings/drawing.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>

#include "depth/colorize.hpp"
#include "depth/mat_view.hpp"

namespace rva {
namespace {

const cv::Scalar green(0, 255, 0);
const cv::Scalar white(255, 255, 255);
const cv::Scalar black(0, 0, 0);

Box scaled(const Box& box, const Image<float>& from, const ColorImage& to) {
  const double along_u = static_cast<double>(to.width()) / from.width();
  const double along_v = static_cast<double>(to.height()) / from.height();
  return {static_cast<int>(box.x * along_u), static_cast<int>(box.y * along_v),
          std::max(1, static_cast<int>(box.width * along_u)),
          std::max(1, static_cast<int>(box.height * along_v))};
}

// Projects a pixel of the depth image into the colour image; empty if the point lies behind the colour
// imager. Requires is_placed().
std::optional<Eigen::Vector2d> on_color(const CaptureInfo& capture, const Eigen::Vector2d& pixel,
                                        double depth_m) {
  const Eigen::Vector3d in_color = *capture.color_from_depth * capture.depth.deproject(pixel, depth_m);
  if (in_color.z() <= 0.0) return std::nullopt;
  return capture.color->project(in_color);
}

bool is_placed(const CaptureInfo& capture) { return capture.color && capture.color_from_depth; }

// Clips [low, high] to an axis of `length` pixels; returns the first pixel and the count.
std::pair<int, int> clipped(double low, double high, int length) {
  const int first = static_cast<int>(std::clamp(std::round(low), 0.0, length - 1.0));
  const int last = static_cast<int>(std::clamp(std::round(high), 0.0, length - 1.0));
  return {first, last - first + 1};
}

// A dark rim keeps a bright line visible on any background. The box is drawn a little outside, so that it
// does not cover a finding of a few pixels.
void draw_box(cv::Mat& picture, const Box& box, int id, const cv::Scalar& color) {
  const int stroke = std::max(1, picture.rows / 300);
  const int gap = stroke + 2;
  const cv::Rect around(box.x - gap, box.y - gap, box.width + 2 * gap, box.height + 2 * gap);
  const cv::Rect rectangle = around & cv::Rect(0, 0, picture.cols, picture.rows);
  cv::rectangle(picture, rectangle, black, stroke + 2);
  cv::rectangle(picture, rectangle, color, stroke);

  const double font = std::max(0.35, picture.rows / 1000.0);
  const std::string label = fmt::format("{}", id);
  int baseline = 0;
  const cv::Size size = cv::getTextSize(label, cv::FONT_HERSHEY_SIMPLEX, font, 1, &baseline);
  const bool above = rectangle.y - size.height - gap >= 0;
  const cv::Point at(
      std::clamp(rectangle.x, 0, std::max(0, picture.cols - size.width)),
      above ? rectangle.y - gap : std::min(picture.rows - 2, rectangle.br().y + size.height + gap));
  cv::putText(picture, label, at, cv::FONT_HERSHEY_SIMPLEX, font, black, stroke + 2, cv::LINE_AA);
  cv::putText(picture, label, at, cv::FONT_HERSHEY_SIMPLEX, font, color, 1, cv::LINE_AA);
}

// Marks pixels that were left out by a pattern as well, so that they do not depend on colour alone.
void hatch(ColorImage& picture, const Mask& left_out) {
  constexpr int period_px = 8;
  for (std::size_t i = 0; i < left_out.size(); ++i) {
    if (left_out[i] == 0) continue;
    const auto width = static_cast<std::size_t>(picture.width());
    const bool line = (i % width + i / width) % period_px == 0;
    const Rgb& pixel = picture[i];
    picture[i] = line ? Rgb{128, 128, 128}
                      : Rgb{static_cast<std::uint8_t>(pixel.r / 3), static_cast<std::uint8_t>(pixel.g / 3),
                            static_cast<std::uint8_t>(pixel.b / 3)};
  }
}

}  // namespace

std::optional<Box> box_on_color(const Finding& finding, const Image<float>& final_m,
                                const CaptureInfo& capture, const ColorImage& color) {
  if (!is_placed(capture)) return scaled(finding.box, final_m, color);
  const auto width = static_cast<std::uint32_t>(final_m.width());
  Eigen::Vector2d low = Eigen::Vector2d::Constant(std::numeric_limits<double>::infinity());
  Eigen::Vector2d high = -low;
  for (const std::uint32_t i : finding.pixels) {
    if (final_m[i] <= 0.0F) continue;
    const auto pixel = on_color(capture, Eigen::Vector2d(i % width, i / width), final_m[i]);
    if (!pixel) continue;
    low = low.cwiseMin(*pixel);
    high = high.cwiseMax(*pixel);
  }
  constexpr double edge_px = 0.5;  // the image reaches half a pixel beyond the centres of its outer pixels
  const bool on_image = high.x() >= -edge_px && high.y() >= -edge_px && low.x() < color.width() - edge_px &&
                        low.y() < color.height() - edge_px;
  if (!on_image) return std::nullopt;  // also if no pixel had a depth, as low and high are infinite then
  const auto [x, box_width] = clipped(low.x(), high.x(), color.width());
  const auto [y, box_height] = clipped(low.y(), high.y(), color.height());
  return Box{x, y, box_width, box_height};
}

Overlay draw_on_color(ColorImage color, const std::vector<Finding>& findings, const Image<float>& final_m,
                      const CaptureInfo& capture) {
  Overlay overlay{std::move(color), 0};
  cv::Mat picture = as_mat(overlay.picture);
  for (const Finding& finding : findings) {
    if (const auto box = box_on_color(finding, final_m, capture, overlay.picture)) {
      draw_box(picture, *box, finding.id, green);
    } else {
      ++overlay.outside;
    }
  }
  return overlay;
}

ColorImage draw_on_depth(const Image<float>& final_m, const std::vector<Finding>& findings,
                         const Mask& left_out) {
  Image<float> measured = final_m;
  for (std::size_t i = 0; i < measured.size(); ++i) {
    if (measured[i] <= 0.0F) measured[i] = std::numeric_limits<float>::quiet_NaN();
  }
  const ColorScale scale = scale_of_depth(measured);
  ColorImage colors = colorize(measured, scale);
  hatch(colors, left_out);
  cv::Mat picture = as_mat(colors);
  for (const Finding& finding : findings) draw_box(picture, finding.box, finding.id, white);
  return with_legend(colors, scale, "depth (m)");
}

ColorImage draw_changed_points(ColorImage color, const Mask& changed, const Image<float>& final_m,
                               const CaptureInfo& capture) {
  for (Rgb& pixel : color.pixels()) {
    const auto grey = static_cast<std::uint8_t>((299 * pixel.r + 587 * pixel.g + 114 * pixel.b) / 1000);
    pixel = {grey, grey, grey};
  }
  const Eigen::Vector2d scale(static_cast<double>(color.width()) / changed.width(),
                              static_cast<double>(color.height()) / changed.height());
  const auto width = static_cast<std::size_t>(changed.width());
  for (std::size_t i = 0; i < changed.size(); ++i) {
    if (changed[i] == 0 || final_m[i] <= 0.0F) continue;
    const std::size_t row = i / width;
    const Eigen::Vector2d at(static_cast<double>(i % width), static_cast<double>(row));
    const auto seen = is_placed(capture) ? on_color(capture, at, final_m[i]) : at.cwiseProduct(scale);
    if (!seen) continue;
    const Eigen::Vector2d nearest = seen->array().round();
    const bool inside = nearest.x() >= 0.0 && nearest.y() >= 0.0 && nearest.x() < color.width() &&
                        nearest.y() < color.height();
    if (inside) color(static_cast<int>(nearest.x()), static_cast<int>(nearest.y())) = {0, 255, 0};
  }
  return color;
}

}  // namespace rva
