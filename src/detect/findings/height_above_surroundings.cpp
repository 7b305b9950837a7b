#include "detect/findings/height_above_surroundings.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <opencv2/imgproc.hpp>
#include <vector>

#include "core/quantile.hpp"
#include "core/random.hpp"
#include "core/units.hpp"
#include "views/disparity_change.hpp"

namespace rva {
namespace {

// In the gap, a matcher's window lies half on the object and half beside it.
constexpr int gap_px = 4;
constexpr int ring_px = 8;
constexpr std::size_t fewest_pixels = 30;

// A surface is a plane to which this share of the ring belongs, each pixel within this share of its depth.
constexpr double least_surface = 0.25;
constexpr double tolerance = 0.006;

/// A measured pixel: u and v from the region's first pixel, 1, and its inverse depth, 1/m. A plane in space
/// is one in inverse depth, too.
struct Measured {
  Eigen::Vector3d at;
  double inverse_m = 0.0;
};
using Pixels = std::vector<Measured>;
using Plane = Eigen::Vector3d;

/// The measured part of a ring around a region.
struct Ring {
  Pixels measured;
  std::size_t pixels = 0;  ///< within the image, measured or not, without those that changed
};

cv::Point place_of(std::uint32_t pixel, int width) {
  return {static_cast<int>(pixel) % width, static_cast<int>(pixel) / width};
}

Measured measured_at(const cv::Point& from_origin, float depth_m) {
  return {{static_cast<double>(from_origin.x), static_cast<double>(from_origin.y), 1.0},
          1.0 / static_cast<double>(depth_m)};
}

cv::Rect around(std::span<const std::uint32_t> pixels, const Image<float>& depth_m) {
  cv::Point low(depth_m.width(), depth_m.height());
  cv::Point high(-1, -1);
  for (const std::uint32_t i : pixels) {
    const cv::Point at = place_of(i, depth_m.width());
    low = {std::min(low.x, at.x), std::min(low.y, at.y)};
    high = {std::max(high.x, at.x), std::max(high.y, at.y)};
  }
  const cv::Point reach(gap_px + ring_px, gap_px + ring_px);
  return cv::Rect(low - reach, high + reach + cv::Point(1, 1)) &
         cv::Rect(0, 0, depth_m.width(), depth_m.height());
}

// Distance of each pixel of the window from the region, pixels.
cv::Mat1f distances(std::span<const std::uint32_t> pixels, int width, const cv::Rect& window) {
  cv::Mat1b outside(window.size(), mask_set);
  for (const std::uint32_t i : pixels) {
    outside(place_of(i, width) - window.tl()) = 0;
  }
  cv::Mat1f distance_px;
  cv::distanceTransform(outside, distance_px, cv::DIST_L2, cv::DIST_MASK_PRECISE);
  return distance_px;
}

bool is_unchanged(float depth_m, float other_m) {
  return other_m <= 0.0F || std::abs(depth_m - other_m) <= tolerance * static_cast<double>(depth_m);
}

Ring ring_around(std::span<const std::uint32_t> pixels, const BeforeAndAfter& depth, const Mask& changed) {
  const cv::Rect window = around(pixels, depth.with_object_m);
  const cv::Mat1f distance_px = distances(pixels, depth.with_object_m.width(), window);
  const cv::Point origin = place_of(pixels.front(), depth.with_object_m.width());
  Ring ring;
  for (int v = 0; v < window.height; ++v) {
    for (int u = 0; u < window.width; ++u) {
      const float from_px = distance_px(v, u);
      const cv::Point at = window.tl() + cv::Point(u, v);
      if (from_px <= gap_px || from_px > gap_px + ring_px || changed(at.x, at.y) != 0) continue;
      ring.pixels += 1;
      const float depth_m = depth.with_object_m(at.x, at.y);
      if (depth_m > 0.0F && is_unchanged(depth_m, depth.without_m(at.x, at.y)))
        ring.measured.push_back(measured_at(at - origin, depth_m));
    }
  }
  return ring;
}

bool is_on(const Plane& plane, const Measured& pixel) {
  return std::abs(plane.dot(pixel.at) - pixel.inverse_m) <= tolerance * pixel.inverse_m;
}

std::size_t count_on(const Plane& plane, const Pixels& pixels) {
  return static_cast<std::size_t>(
      std::ranges::count_if(pixels, [&](const Measured& pixel) { return is_on(plane, pixel); }));
}

Plane fitted(const Plane& start, const Pixels& pixels) {
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Measured& pixel : pixels) {
    if (!is_on(start, pixel)) continue;
    normal += pixel.at * pixel.at.transpose();
    right += pixel.inverse_m * pixel.at;
  }
  return normal.ldlt().solve(right);
}

// The plane with the most pixels, by random samples of three.
Plane largest_plane(const Pixels& pixels, Random& random) {
  constexpr int samples = 150;
  Plane best = Plane::Zero();
  std::size_t most = 0;
  for (int k = 0; k < samples; ++k) {
    Eigen::Matrix3d at;
    Eigen::Vector3d inverse_m;
    for (int row = 0; row < 3; ++row) {
      const Measured& pixel =
          pixels[static_cast<std::size_t>(random.uniform() * static_cast<double>(pixels.size()))];
      at.row(row) = pixel.at;
      inverse_m[row] = pixel.inverse_m;
    }
    if (std::abs(at.determinant()) < 1.0) continue;  // on a line
    const Plane plane = at.inverse() * inverse_m;
    const std::size_t count = count_on(plane, pixels);
    if (count <= most) continue;
    most = count;
    best = plane;
  }
  return most == 0 ? best : fitted(best, pixels);
}

// All surfaces in the ring, the largest first.
std::vector<Plane> surfaces(Pixels pixels) {
  std::vector<Plane> planes;
  Random random(1);
  const double least =
      std::max(static_cast<double>(fewest_pixels), least_surface * static_cast<double>(pixels.size()));
  while (static_cast<double>(pixels.size()) >= least) {
    const Plane plane = largest_plane(pixels, random);
    if (static_cast<double>(count_on(plane, pixels)) < least) break;
    planes.push_back(plane);
    std::erase_if(pixels, [&](const Measured& pixel) { return is_on(plane, pixel); });
  }
  return planes;
}

// Empty where fewer than half of the region's pixels have a height, or the median is not above 0.
std::optional<double> median_of(std::vector<double>& heights_mm, std::size_t region_pixels) {
  if (heights_mm.empty() || 2 * heights_mm.size() < region_pixels) return std::nullopt;
  const double median_mm = quantile(heights_mm, 0.5);
  return median_mm > 0.0 ? std::optional(median_mm) : std::nullopt;
}

// Distances along z from a plane, where it lies in front of the camera.
std::vector<double> heights_above_mm(const Pixels& region, const Plane& plane) {
  std::vector<double> heights_mm;
  for (const Measured& pixel : region) {
    const double inverse_m = plane.dot(pixel.at);
    if (inverse_m > 0.0) heights_mm.push_back(mm_per_m * (1.0 / inverse_m - 1.0 / pixel.inverse_m));
  }
  return heights_mm;
}

// Median over the region; empty where the plane does not lie behind it.
std::optional<double> height_above_mm(const Pixels& region, const Plane& plane) {
  std::vector<double> heights_mm = heights_above_mm(region, plane);
  return median_of(heights_mm, region.size());
}

// Median difference of depth without and with the object; empty where there is none, or none above 0.
std::optional<double> change_mm(std::span<const std::uint32_t> pixels, const BeforeAndAfter& depth) {
  std::vector<double> changes_mm;
  for (const std::uint32_t i : pixels) {
    if (depth.with_object_m[i] > 0.0F && depth.without_m[i] > 0.0F)
      changes_mm.push_back(mm_per_m * static_cast<double>(depth.without_m[i] - depth.with_object_m[i]));
  }
  return median_of(changes_mm, pixels.size());
}

/// A surface that a region's object may lie on.
struct Support {
  Plane plane;
  double height_mm = 0.0;  ///< of the region above it, median along z
  double seen = 0.0;       ///< share of the pixels in which it is looked for that belong to it
};

// The nearest of the planes that lie behind the region.
std::optional<Support> nearest_support(const Pixels& region, const std::vector<Plane>& planes,
                                       const Pixels& around, std::size_t pixels_around) {
  std::optional<Support> nearest;
  for (const Plane& plane : planes) {
    const std::optional<double> height_mm = height_above_mm(region, plane);
    if (!height_mm || (nearest && nearest->height_mm <= *height_mm)) continue;
    const auto on_plane = static_cast<double>(count_on(plane, around));
    nearest = Support{plane, *height_mm, on_plane / static_cast<double>(pixels_around)};
  }
  return nearest;
}

// Where both are one surface, what the object hides is nearer to its place than what is beside it.
std::optional<Support> nearer_of(const std::optional<Support>& hidden, const std::optional<Support>& beside) {
  constexpr double alike = 1.25;
  return hidden && (!beside || hidden->height_mm < alike * beside->height_mm) ? hidden : beside;
}

// The 90th percentile of the distances at right angles to the plane. In camera coordinates, a plane in
// inverse depth, 1 / z = (a, b, c) . (u, v, 1), is n . p = 1 with n = (a fx, b fy, (a, b, c) . (cx, cy, 1)),
// and a point that is h in front of it along z has the distance h / (z |n|), where z is the plane's depth.
double top_above_mm(const Pixels& region, const Plane& plane, const cv::Point& origin,
                    const Intrinsics& camera) {
  constexpr double top = 0.9;
  const Eigen::Vector3d principal(camera.cx - origin.x, camera.cy - origin.y, 1.0);
  const double length =
      Eigen::Vector3d(plane.x() * camera.fx, plane.y() * camera.fy, plane.dot(principal)).norm();
  std::vector<double> heights_mm;
  for (const Measured& pixel : region)
    heights_mm.push_back(mm_per_m * (1.0 - plane.dot(pixel.at) / pixel.inverse_m) / length);
  return quantile(heights_mm, top);
}

Pixels measured(std::span<const std::uint32_t> pixels, const Image<float>& depth_m) {
  Pixels result;
  const int width = depth_m.width();
  for (const std::uint32_t i : pixels) {
    if (depth_m[i] > 0.0F)
      result.push_back(measured_at(place_of(i, width) - place_of(pixels.front(), width), depth_m[i]));
  }
  return result;
}

}  // namespace

std::optional<HeightAboveSurroundings> height_above_surroundings(std::span<const std::uint32_t> pixels,
                                                                 const BeforeAndAfter& depth,
                                                                 const Mask& changed,
                                                                 const Intrinsics& camera) {
  const Pixels region = measured(pixels, depth.with_object_m);
  if (region.empty() || 2 * region.size() < pixels.size()) return std::nullopt;
  const Ring ring = ring_around(pixels, depth, changed);
  if (ring.measured.size() < fewest_pixels || 3 * ring.measured.size() < ring.pixels) return std::nullopt;
  const std::vector<Plane> planes = surfaces(ring.measured);
  if (planes.empty()) return std::nullopt;
  const std::optional<Support> beside = nearest_support(region, planes, ring.measured, ring.pixels);
  // No surface that the object lies on is farther than what is seen where the object is not.
  const std::optional<double> change = change_mm(pixels, depth);
  if (!beside && !change) return std::nullopt;
  HeightAboveSurroundings height;
  height.median_mm = !change || (beside && beside->height_mm < *change) ? beside->height_mm : *change;
  const Pixels hidden = measured(pixels, depth.without_m);
  const std::optional<Support> support =
      nearer_of(nearest_support(region, surfaces(hidden), hidden, pixels.size()), beside);
  if (!support) return height;
  height.top_mm = top_above_mm(region, support->plane, place_of(pixels.front(), changed.width()), camera);
  height.at_least = support->seen < 0.5 || 5 * region.size() < 4 * pixels.size() ||
                    reaches_border(pixels, changed.width(), changed.height());
  return height;
}

bool reaches_border(std::span<const std::uint32_t> pixels, int width, int height) {
  return std::ranges::any_of(pixels, [&](std::uint32_t pixel) {
    const cv::Point at = place_of(pixel, width);
    return std::min({at.x, at.y, width - 1 - at.x, height - 1 - at.y}) <= margin_px;
  });
}

bool is_background_jump(double change_mm, double above_surroundings_mm) {
  constexpr double least_mm = 10.0;
  return change_mm > 2.0 * above_surroundings_mm + least_mm;
}

}  // namespace rva
