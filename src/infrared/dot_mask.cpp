#include "infrared/dot_mask.hpp"

#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/quantile.hpp"
#include "depth/mat_view.hpp"

namespace rva {
namespace {

constexpr std::size_t sampling = 7;

// The deviation of single pixels from the median of their neighbours.
float noise_of(const cv::Mat& image) {
  cv::Mat median;
  cv::medianBlur(image, median, 5);
  std::vector<float> sizes;
  for (std::size_t i = 0; i < image.total(); i += sampling)
    sizes.push_back(std::abs(image.ptr<float>()[i] - median.ptr<float>()[i]));
  return sizes.empty() ? 0.0F : robust_deviation(sizes);
}

}  // namespace

// Equation 53 of docs/math.md.
Image<float> log_grey(const Image<float>& grey, float scale) {
  constexpr float floor_grey = 3.0F;
  Image<float> result(grey.width(), grey.height());
  for (std::size_t i = 0; i < grey.size(); ++i) result[i] = std::log(scale * grey[i] + floor_grey);
  return result;
}

// Equation 54 of docs/math.md.
Mask dot_mask(const Image<float>& log_image) {
  constexpr double least_rise = 0.1;
  constexpr double deviations = 2.5;
  constexpr double smoothing_px = 0.7;
  constexpr int widest_dot_px = 7;
  const cv::Mat image = as_mat(log_image);
  cv::Mat smooth;
  cv::GaussianBlur(image, smooth, {}, smoothing_px);
  cv::Mat background;
  cv::morphologyEx(smooth, background, cv::MORPH_OPEN, cv::Mat::ones(widest_dot_px, widest_dot_px, CV_8U));
  const cv::Mat dots = (smooth - background) > least_rise + deviations * static_cast<double>(noise_of(image));
  Mask mask(log_image.width(), log_image.height());
  cv::Mat widened = as_mat(mask);
  cv::dilate(dots, widened, cv::Mat::ones(3, 3, CV_8U));
  return mask;
}

}  // namespace rva
