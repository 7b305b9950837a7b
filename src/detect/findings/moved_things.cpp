#include "detect/findings/moved_things.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "core/quantile.hpp"
#include "core/units.hpp"

namespace rva {
namespace {

// Outlines follow the matcher's windows, so the length of a side is uncertain by about a pixel and a half,
// whatever its length. Two sides count as equal if they differ by less than that plus 12 % of their
// length; areas accordingly.
constexpr double outline_px = 1.5;
constexpr double alike_share = 0.12;
// Heights of small objects are off by a few millimetres.
constexpr double height_share = 0.3;
constexpr double height_noise_mm = 3.0;

/// Size of a finding on the surface of its object, independent of its orientation in the image.
struct Size {
  double area_mm2 = 0.0;
  double length_mm = 0.0;
  double breadth_mm = 0.0;
  double pixel_mm = 0.0;  ///< edge of one pixel on the surface of the object
  std::optional<double> height_mm;
};

// Median distance of the object's surface, which is the nearer of the surfaces before and after.
std::optional<double> surface_m(const Finding& finding, const Comparison& comparison) {
  std::vector<float> depths_m;
  for (const std::uint32_t i : finding.pixels) {
    const float before_m = comparison.initial_m[i];
    const float after_m = comparison.final_m[i];
    if (before_m > 0.0F && after_m > 0.0F)
      depths_m.push_back(std::min(before_m, after_m));
    else if (before_m > 0.0F || after_m > 0.0F)
      depths_m.push_back(std::max(before_m, after_m));
  }
  return depths_m.empty() ? std::nullopt : std::optional<double>(quantile(depths_m, 0.5));
}

// Sides of the rectangle with the second moments of the pixels: along a side, the variance is side^2 / 12.
Size size_of(const Finding& finding, double distance_m, int width, const Intrinsics& camera) {
  Eigen::Matrix2d moments = Eigen::Matrix2d::Zero();
  const Eigen::Vector2d pixel_mm(mm_per_m * distance_m / camera.fx, mm_per_m * distance_m / camera.fy);
  for (const std::uint32_t i : finding.pixels) {
    const auto at = static_cast<int>(i);
    const Eigen::Vector2d off =
        (Eigen::Vector2d(at % width, at / width) - finding.centroid).cwiseProduct(pixel_mm);
    moments += off * off.transpose();
  }
  moments /= static_cast<double>(finding.pixels.size());
  moments.diagonal() += pixel_mm.cwiseAbs2() / 12.0;  // variance within a pixel
  const Eigen::Vector2d sides_mm =
      (12.0 * Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(moments).eigenvalues()).cwiseSqrt();
  const std::optional<double> height_mm =
      finding.height_mm ? std::optional(std::abs(*finding.height_mm)) : std::nullopt;
  const double area_mm2 = static_cast<double>(finding.pixels.size()) * pixel_mm.prod();
  return {.area_mm2 = area_mm2,
          .length_mm = sides_mm[1],
          .breadth_mm = sides_mm[0],
          .pixel_mm = pixel_mm.mean(),
          .height_mm = height_mm};
}

/// Difference of two sides as a multiple of what is tolerated: equal up to 1.
double side_difference(double a_mm, double b_mm, double pixel_mm) {
  return std::abs(a_mm - b_mm) / (alike_share * std::max(a_mm, b_mm) + outline_px * pixel_mm);
}

double area_difference(const Size& a, const Size& b, double pixel_mm) {
  const double sides_mm = std::max(a.length_mm + a.breadth_mm, b.length_mm + b.breadth_mm);
  const double allowed_mm2 =
      2.0 * alike_share * std::max(a.area_mm2, b.area_mm2) + outline_px * pixel_mm * sides_mm;
  return std::abs(a.area_mm2 - b.area_mm2) / allowed_mm2;
}

double difference(const Size& a, const Size& b) {
  const double pixel_mm = std::max(a.pixel_mm, b.pixel_mm);
  double most =
      std::max({side_difference(a.length_mm, b.length_mm, pixel_mm),
                side_difference(a.breadth_mm, b.breadth_mm, pixel_mm), area_difference(a, b, pixel_mm)});
  if (a.height_mm && b.height_mm) {
    const double allowed_mm = height_share * std::max(*a.height_mm, *b.height_mm) + height_noise_mm;
    most = std::max(most, std::abs(*a.height_mm - *b.height_mm) / allowed_mm);
  }
  return most;
}

struct Pair {
  double difference = 0.0;
  std::size_t added = 0;
  std::size_t removed = 0;
};

using Sizes = std::vector<std::optional<Size>>;

Sizes sizes_of(const std::vector<Finding>& findings, const Comparison& comparison, const Intrinsics& camera) {
  Sizes sizes;
  for (const Finding& finding : findings) {
    const std::optional<double> distance_m = surface_m(finding, comparison);
    sizes.push_back(distance_m
                        ? std::optional(size_of(finding, *distance_m, comparison.changed.width(), camera))
                        : std::nullopt);
  }
  return sizes;
}

// Indices of the findings of `kind` that have a size.
std::vector<std::size_t> sized(const std::vector<Finding>& findings, const Sizes& sizes, ChangeKind kind) {
  std::vector<std::size_t> positions;
  for (std::size_t i = 0; i < findings.size(); ++i) {
    if (findings[i].kind == kind && sizes[i]) positions.push_back(i);
  }
  return positions;
}

// Pairs of an added and a removed finding of equal size, the most similar first.
std::vector<Pair> pairs_alike(const std::vector<Finding>& findings, const Sizes& sizes) {
  std::vector<Pair> alike;
  const std::vector<std::size_t> removed = sized(findings, sizes, ChangeKind::removed);
  for (const std::size_t a : sized(findings, sizes, ChangeKind::added)) {
    for (const std::size_t r : removed) {
      const double how_different = difference(*sizes[a], *sizes[r]);
      if (how_different <= 1.0) alike.push_back({how_different, a, r});
    }
  }
  std::ranges::stable_sort(alike, {}, &Pair::difference);
  return alike;
}

}  // namespace

void find_moved_things(std::vector<Finding>& findings, const Comparison& comparison,
                       const Intrinsics& camera) {
  std::set<std::size_t> taken;
  for (const Pair& pair : pairs_alike(findings, sizes_of(findings, comparison, camera))) {
    Finding& added = findings[pair.added];
    if (added.moved_from || !taken.insert(pair.removed).second) continue;
    added.moved_from = findings[pair.removed].id;
  }
}

}  // namespace rva
