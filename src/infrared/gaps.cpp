#include "infrared/gaps.hpp"

#include <cstddef>
#include <opencv2/imgproc.hpp>
#include <vector>

namespace rva {

bool fill_gaps(const cv::Mat& gaps, Image<float>& image) {
  if (static_cast<std::size_t>(cv::countNonZero(gaps)) == image.size()) return false;
  cv::Mat distance;
  cv::Mat nearest;  // label of the nearest pixel that is not a gap
  cv::distanceTransform(gaps, distance, nearest, cv::DIST_L2, cv::DIST_MASK_5, cv::DIST_LABEL_PIXEL);
  const auto number = [&nearest](std::size_t i) { return static_cast<std::size_t>(nearest.ptr<int>()[i]); };
  std::vector<float> of_number(image.size() + 1, 0.0F);
  for (std::size_t i = 0; i < image.size(); ++i) {
    if (gaps.data[i] == 0) of_number[number(i)] = image[i];
  }
  for (std::size_t i = 0; i < image.size(); ++i) image[i] = of_number[number(i)];
  return true;
}

}  // namespace rva
