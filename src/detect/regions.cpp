#include "detect/regions.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <opencv2/imgproc.hpp>

#include "depth/mat_view.hpp"

namespace rva {
namespace {

using Contour = std::vector<cv::Point>;

// Disjoint sets of contours (Tarjan 1975), with path halving.
class Groups {
 public:
  explicit Groups(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), 0U); }
  std::size_t find(std::size_t member) {
    while (parent_[member] != member) member = parent_[member] = parent_[parent_[member]];
    return member;
  }
  void join(std::size_t a, std::size_t b) { parent_[find(a)] = find(b); }

 private:
  std::vector<std::size_t> parent_;
};

struct Corner {
  int x;
  int y;
  std::size_t contour;
};

// Corners of all contours in square cells, so small that any two corners in one cell are near.
class Grid {
 public:
  Grid(const std::vector<Contour>& contours, int width, int height, double near_px)
      : near_px_(near_px),
        // The largest side with (side - 1) * sqrt(2) < near; two pixels of such a cell are never farther.
        side_(std::max(1, static_cast<int>(std::ceil(std::min(near_px / std::sqrt(2.0), 1e6))))),
        columns_(width / side_ + 1),
        rows_(height / side_ + 1),
        cells_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)) {
    for (std::size_t contour = 0; contour < contours.size(); ++contour) {
      for (const cv::Point& point : contours[contour]) {
        cell(point.x / side_, point.y / side_).push_back({point.x, point.y, contour});
      }
    }
  }

  void join_near(Groups& groups) {
    // Farther cells than these hold no near corner.
    const int reach = static_cast<int>(std::ceil(std::min(near_px_, 1e6) / side_));
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        const std::vector<Corner>& corners = cell(column, row);
        for (std::size_t k = 1; k < corners.size(); ++k)
          groups.join(corners[k - 1].contour, corners[k].contour);
        if (!corners.empty()) join_with_neighbours(column, row, reach, groups);
      }
    }
  }

 private:
  std::vector<Corner>& cell(int column, int row) {
    return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
  }

  // The corners of a cell are one group by now, so one near pair joins two cells; each pair of cells is
  // looked at once, from the upper or left of the two.
  void join_with_neighbours(int column, int row, int reach, Groups& groups) {
    const std::vector<Corner>& here = cell(column, row);
    for (int other_row = row; other_row <= std::min(rows_ - 1, row + reach); ++other_row) {
      const int first = other_row == row ? column + 1 : std::max(0, column - reach);
      for (int other_column = first; other_column <= std::min(columns_ - 1, column + reach); ++other_column) {
        const std::vector<Corner>& there = cell(other_column, other_row);
        if (there.empty() || groups.find(here[0].contour) == groups.find(there[0].contour)) continue;
        if (any_near(here, there)) groups.join(here[0].contour, there[0].contour);
      }
    }
  }

  [[nodiscard]] bool any_near(const std::vector<Corner>& a, const std::vector<Corner>& b) const {
    return std::ranges::any_of(a, [&](const Corner& p) {
      return std::ranges::any_of(b, [&](const Corner& q) {
        const double dx = p.x - q.x;
        const double dy = p.y - q.y;
        return std::sqrt(dx * dx + dy * dy) < near_px_;
      });
    });
  }

  double near_px_;
  int side_;
  int columns_;
  int rows_;
  std::vector<std::vector<Corner>> cells_;
};

// Blobs by label; label 0 is what did not change.
struct Blobs {
  cv::Mat labels;
  cv::Mat stats;

  explicit Blobs(const cv::Mat& changed) {
    cv::Mat centroids;
    cv::connectedComponentsWithStats(changed, labels, stats, centroids, 8, CV_32S);
  }
  [[nodiscard]] int area(int label) const { return stats.at<int>(label, cv::CC_STAT_AREA); }
  [[nodiscard]] int at(const cv::Point& point) const { return labels.at<int>(point); }
};

cv::Mat without_small_blobs(const cv::Mat& changed, const Blobs& blobs, int min_blob_px) {
  cv::Mat kept(changed.size(), CV_8UC1);
  for (int v = 0; v < changed.rows; ++v) {
    const int* labels = blobs.labels.ptr<int>(v);
    auto* row = kept.ptr<std::uint8_t>(v);
    for (int u = 0; u < changed.cols; ++u) {
      row[u] = labels[u] != 0 && blobs.area(labels[u]) >= min_blob_px ? mask_set : std::uint8_t{0};
    }
  }
  return kept;
}

Box united(const Box& a, const cv::Rect& b) {
  if (a.width == 0) return {b.x, b.y, b.width, b.height};
  const int left = std::min(a.x, b.x);
  const int top = std::min(a.y, b.y);
  return {left, top, std::max(a.x + a.width, b.x + b.width) - left,
          std::max(a.y + a.height, b.y + b.height) - top};
}

// findContours walks a blob's outer border counter-clockwise (in an image whose v runs down) and its holes
// clockwise; a border without area is a line or a point, so an outer one.
bool is_hole(const Contour& contour) { return cv::contourArea(contour, true) > 0.0; }

std::vector<std::uint32_t> pixels_of_blob_in(const Box& box, int label, const Blobs& blobs) {
  std::vector<std::uint32_t> pixels;
  for (int v = box.y; v < box.y + box.height; ++v) {
    for (int u = box.x; u < box.x + box.width; ++u) {
      if (blobs.at({u, v}) == label) pixels.push_back(static_cast<std::uint32_t>(v * blobs.labels.cols + u));
    }
  }
  return pixels;
}

// Hands every pixel to the region that holds its blob's outer border.
void collect_pixels(const Blobs& blobs, const std::vector<int>& region_of_label,
                    std::vector<Region>& regions) {
  std::uint32_t position = 0;
  for (int v = 0; v < blobs.labels.rows; ++v) {
    const int* labels = blobs.labels.ptr<int>(v);
    for (int u = 0; u < blobs.labels.cols; ++u, ++position) {
      const int region = labels[u] == 0 ? -1 : region_of_label[static_cast<std::size_t>(labels[u])];
      if (region >= 0) regions[static_cast<std::size_t>(region)].pixels.push_back(position);
    }
  }
}

}  // namespace

std::vector<Region> find_regions(const Mask& changed, const RegionOptions& options) {
  if (changed.empty()) return {};
  const cv::Mat all = as_mat(changed);
  const Blobs blobs(all);
  std::vector<Contour> contours;
  cv::findContours(options.min_blob_px > 1 ? without_small_blobs(all, blobs, options.min_blob_px) : all,
                   contours, cv::RETR_LIST, cv::CHAIN_APPROX_SIMPLE);

  Groups groups(contours.size());
  if (options.join_px > 0.0)
    Grid(contours, changed.width(), changed.height(), options.join_px).join_near(groups);

  std::vector<Region> regions;
  std::map<std::size_t, int> region_of_group;
  std::vector<int> region_of_label(static_cast<std::size_t>(blobs.stats.rows), -1);
  std::vector<int> hole_label;  // by region: a label whose hole lies in it
  for (std::size_t k = 0; k < contours.size(); ++k) {
    const auto [entry, is_new] =
        region_of_group.try_emplace(groups.find(k), static_cast<int>(regions.size()));
    if (is_new) {
      regions.emplace_back();
      hole_label.push_back(0);
    }
    Region& region = regions[static_cast<std::size_t>(entry->second)];
    region.box = united(region.box, cv::boundingRect(contours[k]));
    const int label = blobs.at(contours[k][0]);
    if (is_hole(contours[k])) {
      hole_label[static_cast<std::size_t>(entry->second)] = label;
    } else {
      region_of_label[static_cast<std::size_t>(label)] = entry->second;
    }
  }
  collect_pixels(blobs, region_of_label, regions);
  for (std::size_t k = 0; k < regions.size(); ++k) {
    if (regions[k].pixels.empty())
      regions[k].pixels = pixels_of_blob_in(regions[k].box, hole_label[k], blobs);
  }
  std::ranges::sort(regions, [](const Region& a, const Region& b) {
    return std::tie(a.box.y, a.box.x, a.box.height, a.box.width) <
           std::tie(b.box.y, b.box.x, b.box.height, b.box.width);
  });
  return regions;
}

}  // namespace rva
