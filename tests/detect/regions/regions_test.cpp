#include "detect/regions/regions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <numeric>
#include <opencv2/imgproc.hpp>
#include <random>
#include <set>

#include "depth/mat_view.hpp"

namespace rva {
namespace {

using Contour = std::vector<cv::Point>;

std::vector<Contour> contours_of_large_blobs(const Mask& changed, int min_blob_px) {
  cv::Mat labels;
  cv::Mat stats;
  cv::Mat centroids;
  cv::Mat kept = as_mat(changed).clone();
  const int count = cv::connectedComponentsWithStats(kept, labels, stats, centroids, 8, CV_32S);
  for (int label = 1; label < count; ++label) {
    if (stats.at<int>(label, cv::CC_STAT_AREA) < min_blob_px) kept.setTo(0, labels == label);
  }
  std::vector<Contour> contours;
  cv::findContours(kept, contours, cv::RETR_LIST, cv::CHAIN_APPROX_SIMPLE);
  return contours;
}

bool any_near(const Contour& a, const Contour& b, double join_px) {
  return std::ranges::any_of(a, [&](const cv::Point& p) {
    return std::ranges::any_of(b, [&](const cv::Point& q) { return cv::norm(p - q) < join_px; });
  });
}

// The thesis' way, all pairs of contour points, as plain as can be.
std::vector<Box> boxes_by_all_pairs(const Mask& changed, const RegionOptions& options) {
  const std::vector<Contour> contours = contours_of_large_blobs(changed, options.min_blob_px);
  std::vector<std::size_t> group(contours.size());
  std::iota(group.begin(), group.end(), 0U);
  for (std::size_t a = 0; a < contours.size(); ++a) {
    for (std::size_t b = a + 1; b < contours.size(); ++b) {
      if (any_near(contours[a], contours[b], options.join_px)) {
        std::ranges::replace(group, std::size_t{group[b]}, std::size_t{group[a]});
      }
    }
  }
  std::map<std::size_t, Contour> points;
  for (std::size_t k = 0; k < contours.size(); ++k) {
    points[group[k]].insert(points[group[k]].end(), contours[k].begin(), contours[k].end());
  }
  std::vector<Box> boxes;
  for (const auto& [id, members] : points) {
    const cv::Rect box = cv::boundingRect(members);
    boxes.push_back({box.x, box.y, box.width, box.height});
  }
  std::ranges::sort(boxes);
  return boxes;
}

std::vector<Box> boxes_of(const std::vector<Region>& regions) {
  std::vector<Box> boxes;
  for (const Region& region : regions) boxes.push_back(region.box);
  std::ranges::sort(boxes);
  return boxes;
}

void fill(Mask& mask, const Box& box, std::uint8_t value = mask_set) {
  for (int v = std::max(0, box.y); v < std::min(mask.height(), box.y + box.height); ++v) {
    for (int u = std::max(0, box.x); u < std::min(mask.width(), box.x + box.width); ++u) mask(u, v) = value;
  }
}

// Blobs, blobs with holes, blobs inside holes, and single pixels.
Mask random_mask(std::mt19937& random) {
  const auto below = [&](int limit) { return static_cast<int>(random() % static_cast<unsigned>(limit)); };
  Mask mask(40 + below(160), 30 + below(120));
  for (int k = below(14); k >= 0; --k) {
    const Box box{below(mask.width()), below(mask.height()), 1 + below(70), 1 + below(70)};
    fill(mask, box);
    if (below(2) == 0) fill(mask, {box.x + below(20), box.y + below(20), 1 + below(60), 1 + below(60)}, 0);
  }
  const int specks = below(60);
  for (int k = 0; k < specks; ++k) mask(below(mask.width()), below(mask.height())) = mask_set;
  return mask;
}

TEST(Regions, AgreeWithAllPairsOfContourPoints) {
  std::mt19937 random(5);
  std::size_t boxes = 0;
  for (int trial = 0; trial < 300; ++trial) {
    const Mask mask = random_mask(random);
    const RegionOptions options{static_cast<int>(random() % 12),
                                std::vector<double>{0, 0.5, 1, 1.5, 2, 5.5, 12, 30, 1000}[random() % 9]};
    const std::vector<Box> expected = boxes_by_all_pairs(mask, options);
    ASSERT_EQ(boxes_of(find_regions(mask, options)), expected)
        << "trial " << trial << ", join " << options.join_px;
    boxes += expected.size();
  }
  EXPECT_GT(boxes, 1000U);
}

// Whatever the mask: every pixel of a blob that is large enough is in exactly one region, within its box.
TEST(Regions, SharePixelsOutOnce) {
  std::mt19937 random(6);
  for (int trial = 0; trial < 100; ++trial) {
    const Mask mask = random_mask(random);
    const RegionOptions options{0, 1000.0};  // so far that no hole makes a region of its own
    std::multiset<std::uint32_t> given;
    for (const Region& region : find_regions(mask, options)) {
      EXPECT_TRUE(std::ranges::is_sorted(region.pixels));
      for (const std::uint32_t i : region.pixels) {
        given.insert(i);
        const int u = static_cast<int>(i) % mask.width();
        const int v = static_cast<int>(i) / mask.width();
        EXPECT_TRUE(u >= region.box.x && u < region.box.x + region.box.width);
        EXPECT_TRUE(v >= region.box.y && v < region.box.y + region.box.height);
      }
    }
    std::multiset<std::uint32_t> changed;
    for (std::uint32_t i = 0; i < mask.size(); ++i) {
      if (mask[i] != 0) changed.insert(i);
    }
    ASSERT_EQ(given, changed);
  }
}

TEST(Regions, JoinIsNearerThanNotAsNearAs) {
  Mask mask(100, 20);
  mask(10, 10) = mask(40, 10) = mask_set;
  EXPECT_EQ(find_regions(mask, {0, 30.0}).size(), 2U);
  EXPECT_EQ(find_regions(mask, {0, 30.001}).size(), 1U);
}

TEST(Regions, JoinInAChain) {
  Mask mask(200, 5);
  for (int u = 0; u < 200; u += 20) mask(u, 2) = mask_set;
  const std::vector<Region> regions = find_regions(mask, {0, 30.0});
  ASSERT_EQ(regions.size(), 1U);
  EXPECT_EQ(regions[0].box, (Box{0, 2, 181, 1}));
  EXPECT_EQ(regions[0].pixels.size(), 10U);
}

TEST(Regions, SmallBlobsAreLeftOutBeforeJoining) {
  Mask mask(100, 20);
  fill(mask, {0, 0, 4, 4});
  mask(20, 2) = mask_set;  // a stepping stone that is too small
  fill(mask, {40, 0, 4, 4});
  EXPECT_EQ(find_regions(mask, {0, 30.0}).size(), 1U);
  EXPECT_EQ(find_regions(mask, {2, 30.0}).size(), 2U);
  EXPECT_EQ(find_regions(mask, {16, 30.0}).size(), 2U);
  EXPECT_EQ(find_regions(mask, {17, 30.0}).size(), 0U);
}

TEST(Regions, DiagonalNeighboursAreOneBlob) {
  Mask mask(10, 10);
  mask(1, 1) = mask(2, 2) = mask(3, 1) = mask_set;
  EXPECT_EQ(find_regions(mask, {3, 0.0}).size(), 1U);
}

TEST(Regions, AHoleFarFromItsBorderIsARegionAsInTheThesis) {
  Mask mask(200, 200);
  fill(mask, {0, 0, 200, 200});
  mask(100, 100) = 0;
  const std::vector<Region> regions = find_regions(mask, {});
  ASSERT_EQ(regions.size(), 2U);
  EXPECT_EQ(regions[0].pixels.size(), 200U * 200U - 1U);
  EXPECT_EQ(regions[1].box, (Box{99, 99, 3, 3}));
  EXPECT_EQ(regions[1].pixels.size(), 8U);
}

// Two blobs, a pixel apart, with a hole each beside the gap: one box for both holes, with pixels of both
// blobs.
TEST(Regions, HolesOfTwoBlobsMayShareARegion) {
  Mask mask(400, 400);
  fill(mask, {0, 60, 209, 280});
  fill(mask, {210, 60, 190, 280});
  mask(200, 150) = mask(218, 150) = 0;
  const std::vector<Region> regions = find_regions(mask, {});
  const auto shared = std::ranges::find(regions, Box{199, 149, 21, 3}, &Region::box);
  ASSERT_NE(shared, regions.end());
  EXPECT_EQ(shared->pixels.size(), 21U * 3U - 3U - 2U);
  EXPECT_TRUE(std::ranges::is_sorted(shared->pixels));
}

TEST(Regions, EmptyAndFullMasks) {
  EXPECT_TRUE(find_regions(Mask(), {}).empty());
  EXPECT_TRUE(find_regions(Mask(50, 40), {}).empty());
  const std::vector<Region> all = find_regions(Mask(50, 40, mask_set), {});
  ASSERT_EQ(all.size(), 1U);
  EXPECT_EQ(all[0].box, (Box{0, 0, 50, 40}));
}

}  // namespace
}  // namespace rva
