#include "infrared/projector_field.hpp"

#include <opencv2/imgproc.hpp>

#include "depth/mat_view.hpp"
#include "infrared/dot_mask.hpp"

namespace rva {
namespace {

cv::Mat widened(const cv::Mat& mask, int by_px) {
  cv::Mat wide;
  cv::dilate(mask, wide, cv::Mat::ones(2 * by_px + 1, 2 * by_px + 1, CV_8U));
  return wide;
}

// The parts of a mask that touch the border of the image.
cv::Mat touching_border(const cv::Mat& mask) {
  constexpr int frame_px = 1;
  cv::Mat framed;
  cv::copyMakeBorder(mask, framed, frame_px, frame_px, frame_px, frame_px, cv::BORDER_CONSTANT, mask_set);
  cv::Mat parts;
  cv::connectedComponents(framed, parts);
  const int frame = parts.at<int>(0, 0);
  return (parts == frame)(cv::Rect(frame_px, frame_px, mask.cols, mask.rows));
}

// Set where a window contains hardly any dots, which for windows of 25 pixels begins about nine pixels beyond
// the last dots. The border pixels are repeated outside the image, since a reflection of dots would fill a
// darker strip along the border.
cv::Mat few_dots(const Mask& dots, cv::Size window_px) {
  constexpr double least_dots = 0.03 * mask_set;  // share of the window; within the field it is 0.2 and more
  cv::Mat share;
  cv::blur(as_mat(dots), share, window_px, {-1, -1}, cv::BORDER_REPLICATE);
  return share < least_dots;
}

const cv::Size square_px{25, 25};

// The area beyond the field, including narrow strips along a border.
cv::Mat beyond_field(const Mask& dots) {
  const cv::Size upright_px{13, 61};
  const cv::Size lying_px{61, 13};
  return touching_border(few_dots(dots, square_px) | few_dots(dots, upright_px) | few_dots(dots, lying_px));
}

// Set where other light sources are bright enough for a matcher.
cv::Mat is_bright(const Image<float>& log_image) {
  constexpr int window_px = 15;
  constexpr float bright_grey = 10.0F;
  const float bright = log_grey(Image<float>(1, 1, bright_grey))[0];
  cv::Mat around;
  cv::blur(as_mat(log_image), around, {window_px, window_px});
  return around > static_cast<double>(bright);
}

}  // namespace

Mask without_dots(const Mask& dots) {
  constexpr int beside_hole_px = 6;
  Mask without(dots.width(), dots.height());
  cv::Mat target = as_mat(without);
  cv::bitwise_or(widened(few_dots(dots, square_px), beside_hole_px),
                 widened(beyond_field(dots), beside_field_px), target);
  return without;
}

Mask beyond_projector(const Image<float>& log_image, const Mask& dots, int beside_px) {
  const cv::Mat dark = beyond_field(dots) & ~is_bright(log_image);
  Mask beyond(dots.width(), dots.height());
  widened(dark, beside_px).copyTo(as_mat(beyond));
  return beyond;
}

}  // namespace rva
