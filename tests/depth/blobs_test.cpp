#include "depth/blobs.hpp"

#include <gtest/gtest.h>

#include <map>
#include <opencv2/imgproc.hpp>
#include <random>

#include "depth/mat_view.hpp"

namespace rva {
namespace {

Mask random_mask(std::mt19937& random) {
  Mask mask(1 + static_cast<int>(random() % 70), 1 + static_cast<int>(random() % 50));
  std::bernoulli_distribution set(std::vector<double>{0.0, 0.02, 0.3, 0.5, 0.9, 1.0}[random() % 6]);
  for (std::uint8_t& pixel : mask.pixels()) pixel = set(random) ? mask_set : std::uint8_t{0};
  return mask;
}

// OpenCV's labels of the set pixels, by position.
std::map<std::pair<int, int>, int> labels_of(const Mask& mask) {
  cv::Mat labels;
  cv::connectedComponents(as_mat(mask), labels, 8, CV_32S);
  std::map<std::pair<int, int>, int> label_at;
  for (int v = 0; v < mask.height(); ++v) {
    for (int u = 0; u < mask.width(); ++u) {
      if (mask(u, v) != 0) label_at[{u, v}] = labels.at<int>(v, u);
    }
  }
  return label_at;
}

TEST(Blobs, AgreeWithConnectedComponentsUpToTheirOrder) {
  std::mt19937 random(4);
  for (int trial = 0; trial < 300; ++trial) {
    const Mask mask = random_mask(random);
    const Blobs blobs(mask);
    std::map<int, std::size_t> blob_of_label;
    std::map<std::size_t, int> areas;
    for (const auto& [pixel, label] : labels_of(mask)) {
      const std::size_t blob = blobs.blob_at(pixel.first, pixel.second);
      ASSERT_EQ(blob_of_label.try_emplace(label, blob).first->second, blob);
      ++areas[blob];
    }
    ASSERT_EQ(blobs.count(), blob_of_label.size());
    ASSERT_EQ(blobs.count(), areas.size());
    for (const auto& [blob, area] : areas) ASSERT_EQ(blobs.area_px(blob), area);
  }
}

}  // namespace
}  // namespace rva
