#include "detect/regions/regions.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <opencv2/imgproc.hpp>
#include <set>
#include <tuple>

#include "depth/blobs.hpp"
#include "depth/disjoint_sets.hpp"
#include "depth/mat_view.hpp"

namespace rva {
namespace {

using Contour = std::vector<cv::Point>;

struct Corner {
  int x;
  int y;
  std::size_t contour;
};

// Corners of all contours, sorted into square cells so small that any two corners in one cell are near.
class Grid {
 public:
  Grid(const std::vector<Contour>& contours, int width, int height, double near_px)
      : near_px_(near_px),
        // The largest side with (side - 1) * sqrt(2) < near: no two pixels of such a cell are farther apart.
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

  void join_near(DisjointSets& groups) {
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        const std::vector<Corner>& corners = cell(column, row);
        for (std::size_t k = 1; k < corners.size(); ++k)
          groups.join(corners[k - 1].contour, corners[k].contour);
      }
    }
    for (int row = 0; row < rows_; ++row) {
      for (int column = 0; column < columns_; ++column) {
        if (!cell(column, row).empty()) join_with_neighbours(column, row, groups);
      }
    }
  }

 private:
  std::vector<Corner>& cell(int column, int row) {
    return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
  }

  // The corners of a cell form one group by now, so one near pair joins two cells. Each pair of cells is
  // examined once, from the upper or left of the two.
  void join_with_neighbours(int column, int row, DisjointSets& groups) {
    const int reach = static_cast<int>(std::ceil(std::min(near_px_, 1e6) / side_));
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

// Borders of the blobs that are large enough: outer borders and those of holes.
std::vector<Contour> find_contours(const Mask& changed, const Blobs& blobs, int min_blob_px) {
  Mask kept(changed.width(), changed.height());
  for (const Run& run : blobs.runs()) {
    if (blobs.area_px(run.blob) < min_blob_px) continue;
    std::fill(&kept(run.first, run.v), &kept(run.first, run.v) + (run.end - run.first), mask_set);
  }
  std::vector<Contour> contours;
  cv::findContours(as_mat(kept), contours, cv::RETR_LIST, cv::CHAIN_APPROX_SIMPLE);
  return contours;
}

// findContours walks the outer border of a blob counter-clockwise (in an image whose v runs down) and its
// holes clockwise. A border without area is a line or a point, and so an outer one.
bool is_hole(const Contour& contour) { return cv::contourArea(contour, true) > 0.0; }

void extend(Box& box, const cv::Rect& by) {
  if (box.width == 0) {
    box = {by.x, by.y, by.width, by.height};
    return;
  }
  const int right = std::max(box.x + box.width, by.x + by.width);
  const int bottom = std::max(box.y + box.height, by.y + by.height);
  box.x = std::min(box.x, by.x);
  box.y = std::min(box.y, by.y);
  box.width = right - box.x;
  box.height = bottom - box.y;
}

void append(std::vector<std::uint32_t>& pixels, const Run& run, int first, int end, int width) {
  for (int u = first; u < end; ++u) pixels.push_back(static_cast<std::uint32_t>(run.v * width + u));
}

constexpr std::size_t none = std::numeric_limits<std::size_t>::max();

// Assembles regions: first their boxes from contours, then their pixels from blobs.
class Assembly {
 public:
  Assembly(const Blobs& blobs, int width)
      : blobs_(blobs), width_(width), region_of_blob_(blobs.count(), none) {}

  void add(const std::vector<Contour>& contours, DisjointSets& groups) {
    std::vector<std::size_t> region_of_group(contours.size(), none);
    for (std::size_t k = 0; k < contours.size(); ++k) {
      std::size_t& region = region_of_group[groups.find(k)];
      if (region == none) {
        region = regions_.size();
        regions_.emplace_back();
        blobs_around_holes_.emplace_back();
      }
      extend(regions_[region].box, cv::boundingRect(contours[k]));
      const std::size_t blob = blobs_.blob_at(contours[k][0].x, contours[k][0].y);
      if (is_hole(contours[k])) {
        blobs_around_holes_[region].insert(blob);
      } else {
        region_of_blob_[blob] = region;
      }
    }
  }

  // The pixels of a blob go to the region that contains its outer border. A region that consists of holes
  // only takes the pixels of the surrounding blobs within its box.
  std::vector<Region> with_pixels() && {
    for (const Run& run : blobs_.runs()) {
      const std::size_t region = region_of_blob_[run.blob];
      if (region != none) append(regions_[region].pixels, run, run.first, run.end, width_);
    }
    for (std::size_t k = 0; k < regions_.size(); ++k) {
      if (regions_[k].pixels.empty()) take_pixels_around_holes(regions_[k], blobs_around_holes_[k]);
    }
    return std::move(regions_);
  }

 private:
  void take_pixels_around_holes(Region& region, const std::set<std::size_t>& blobs) const {
    const Box& box = region.box;
    for (int v = box.y; v < box.y + box.height; ++v) {
      for (const Run& run : blobs_.runs_of_row(v)) {
        if (!blobs.contains(run.blob)) continue;
        append(region.pixels, run, std::max(run.first, box.x), std::min(run.end, box.x + box.width), width_);
      }
    }
  }

  const Blobs& blobs_;
  int width_;
  std::vector<Region> regions_;
  std::vector<std::size_t> region_of_blob_;
  std::vector<std::set<std::size_t>> blobs_around_holes_;  // by region
};

}  // namespace

std::vector<Region> find_regions(const Mask& changed, const RegionOptions& options) {
  const Blobs blobs(changed);
  if (blobs.count() == 0) return {};
  const std::vector<Contour> contours = find_contours(changed, blobs, options.min_blob_px);
  DisjointSets groups(contours.size());
  if (options.join_px > 0.0)
    Grid(contours, changed.width(), changed.height(), options.join_px).join_near(groups);
  Assembly assembly(blobs, changed.width());
  assembly.add(contours, groups);
  std::vector<Region> regions = std::move(assembly).with_pixels();
  std::ranges::sort(regions, {}, [](const Region& region) {
    return std::tuple(region.box.y, region.box.x, region.box.height, region.box.width);
  });
  return regions;
}

}  // namespace rva
