#include "detect/blobs.hpp"

#include <gtest/gtest.h>

#include <map>
#include <opencv2/imgproc.hpp>
#include <random>

#include "depth/mat_view.hpp"

namespace rva {
namespace {

// OpenCV's labels, up to their order.
TEST(Blobs, AgreeWithConnectedComponents) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 300; ++trial) {
    Mask mask(1 + static_cast<int>(random() % 70), 1 + static_cast<int>(random() % 50));
    std::bernoulli_distribution set(std::vector<double>{0.0, 0.02, 0.3, 0.5, 0.9, 1.0}[random() % 6]);
    for (std::uint8_t& pixel : mask.pixels()) pixel = set(random) ? mask_set : std::uint8_t{0};
    cv::Mat labels;
    const int count = cv::connectedComponents(as_mat(mask), labels, 8, CV_32S) - 1;
    const Blobs blobs(mask);
    ASSERT_EQ(blobs.count(), static_cast<std::size_t>(count));
    std::map<int, std::size_t> blob_of_label;
    std::vector<int> areas(blobs.count());
    for (int v = 0; v < mask.height(); ++v) {
      for (int u = 0; u < mask.width(); ++u) {
        if (mask(u, v) == 0) continue;
        const std::size_t blob = blobs.blob_at(u, v);
        ASSERT_EQ(blob_of_label.try_emplace(labels.at<int>(v, u), blob).first->second, blob);
        ++areas[blob];
      }
    }
    ASSERT_EQ(blob_of_label.size(), blobs.count());
    for (std::size_t k = 0; k < blobs.count(); ++k) ASSERT_EQ(blobs.area_px(k), areas[k]);
  }
}

}  // namespace
}  // namespace rva
