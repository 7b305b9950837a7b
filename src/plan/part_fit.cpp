#include "plan/part_fit.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <opencv2/imgproc.hpp>

#include "core/units.hpp"

namespace rva {
namespace {

// A stereo matcher's window widens what it shows by half of it on each side.
constexpr double half_window_px = 4.5;
// What is smaller than one and a half windows mixes with its surroundings, and its depth may be a wrong
// match.
constexpr int resolved_from_px = 14;
// A place counts as covered by a piece if it is this near to one of its pixels.
constexpr double upon_px = 2.0;

// By how much a height is off the item's range as a share of its uncertainty; above 1 if it does not fit.
double misfit_of(double height_mm, const PlannedItem& item, double uncertainty_mm) {
  const double toward_kind_mm = item.kind == ChangeKind::removed ? -height_mm : height_mm;
  const double off_mm =
      std::max({item.height_mm.low - toward_kind_mm, toward_kind_mm - item.height_mm.high, 0.0});
  return off_mm == 0.0 ? 0.0 : off_mm / std::max(uncertainty_mm, 1e-6);
}

// The height is the change of depth, or, at an edge, where that has the background in it, the height above
// the surroundings: whichever fits better.
double misfit_of(const Piece& piece, const PlannedItem& item, const PlanOptions& options) {
  constexpr double none = 2.0;
  if (piece.kind == ChangeKind::appearance) return 0.0;
  if (item.kind == ChangeKind::appearance) return none;
  if (!piece.height_mm) return piece.kind == item.kind ? 0.0 : none;
  const double uncertainty_mm = std::max(options.height_error_mm, piece.level_mm.value_or(0.0));
  double misfit = misfit_of(*piece.height_mm, item, uncertainty_mm);
  if (piece.above_surroundings_mm && piece.kind == item.kind)
    misfit = std::min(misfit, misfit_of(std::copysign(*piece.above_surroundings_mm, *piece.height_mm), item,
                                        uncertainty_mm));
  return misfit;
}

std::vector<cv::Point2f> points_of(const std::vector<Eigen::Vector2d>& pixels) {
  std::vector<cv::Point2f> points;
  for (const Eigen::Vector2d& pixel : pixels)
    points.emplace_back(static_cast<float>(pixel.x()), static_cast<float>(pixel.y()));
  return points;
}

bool is_in(const Polygon& area, const Eigen::Vector2d& pixel) {
  return cv::pointPolygonTest(points_of(area), {static_cast<float>(pixel.x()), static_cast<float>(pixel.y())},
                              false) >= 0.0;
}

double distance_px(const Piece& piece, const Eigen::Vector2d& place) {
  double least_px = (piece.outline.front() - place).norm();
  for (const Eigen::Vector2d& pixel : piece.outline) least_px = std::min(least_px, (pixel - place).norm());
  return least_px;
}

std::vector<PlaceFit> places_of(const Piece& piece, const PictureItem& item, double mm_per_px) {
  std::vector<PlaceFit> places;
  for (std::size_t k = 0; k < item.places.size(); ++k) {
    const double distance_mm = mm_per_px * (piece.centroid - item.places[k]).norm();
    if (distance_mm <= item.item->tolerance_mm || distance_px(piece, item.places[k]) <= upon_px)
      places.push_back({k, distance_mm});
  }
  return places;
}

// Whether nearly all of the piece is about the places that it is at.
bool stays_at_its_places(const Piece& piece, const PictureItem& item, const std::vector<PlaceFit>& places,
                         double mm_per_px) {
  constexpr double nearly_all = 0.9;
  const double within_px =
      half_window_px + (item.item->size_mm->high / 2 + item.item->tolerance_mm) / mm_per_px;
  const auto near = std::ranges::count_if(piece.outline, [&](const Eigen::Vector2d& pixel) {
    return std::ranges::any_of(
        places, [&](const PlaceFit& fit) { return (pixel - item.places[fit.place]).norm() <= within_px; });
  });
  return static_cast<double>(near) >= nearly_all * static_cast<double>(piece.outline.size());
}

// Length and breadth of a piece without what the matcher's window adds, mm.
std::array<double, 2> sides_mm(const Piece& piece, double mm_per_px) {
  const cv::RotatedRect box = cv::minAreaRect(points_of(piece.outline));
  const auto [low_px, high_px] = std::minmax(box.size.width, box.size.height);
  return {std::max(0.0, 1.0 + high_px - 2 * half_window_px) * mm_per_px,
          std::max(0.0, 1.0 + low_px - 2 * half_window_px) * mm_per_px};
}

void judge_size(const Piece& piece, const PictureItem& item, double mm_per_px, PartFit& fit) {
  const std::optional<RangeMm>& size_mm = item.item->size_mm;
  if (!size_mm) return;
  fit.too_small = mm_per_px * std::max(piece.box.width, piece.box.height) < size_mm->low / 2;
  const auto [length_mm, breadth_mm] = sides_mm(piece, mm_per_px);
  if (length_mm <= size_mm->high) return;
  if (!fit.places.empty())
    fit.too_large = !stays_at_its_places(piece, item, fit.places, mm_per_px);
  else
    fit.too_large = breadth_mm > size_mm->high;
  fit.several = !fit.too_large;
}

bool is_resolved(const Piece& piece) {
  return piece.height_mm && (piece.box.width >= resolved_from_px || piece.box.height >= resolved_from_px);
}

double mean_depth_m(const PlannedItem& item) {
  const std::vector<PlanPoint>& points = item.places.empty() ? item.areas.front() : item.places;
  double sum_m = 0.0;
  for (const PlanPoint& point : points) sum_m += point.depth_m;
  return sum_m / static_cast<double>(points.size());
}

// The plan's depth is used where there is one: that of a small piece at an edge may be a wrong match. Without
// any, a piece has no size, and only places right upon it count.
double scale_mm_per_px(const Piece& piece, const PictureItem& item, double focal_px) {
  constexpr double far_m = 1e6;
  return mm_per_m * (item.depth_m ? *item.depth_m : piece.depth_m.value_or(far_m)) / focal_px;
}

}  // namespace

std::vector<PictureItem> in_picture(const Plan& plan, const Intrinsics& camera) {
  const auto pixel_of = [&](const PlanPoint& point) -> Eigen::Vector2d {
    return plan.coordinates == PlanCoordinates::pixels ? point.at : camera.project(point.at.homogeneous());
  };
  std::vector<PictureItem> items;
  for (const PlannedItem& item : plan.items) {
    items.push_back({&item, {}, {}, std::nullopt});
    for (const std::vector<PlanPoint>& area : item.areas) {
      Polygon& polygon = items.back().areas.emplace_back();
      for (const PlanPoint& corner : area) polygon.push_back(pixel_of(corner));
    }
    for (const PlanPoint& place : item.places) items.back().places.push_back(pixel_of(place));
    if (plan.coordinates == PlanCoordinates::metres) items.back().depth_m = mean_depth_m(item);
  }
  return items;
}

std::optional<PartFit> fit_of(const Piece& piece, const PictureItem& item, double focal_px,
                              const PlanOptions& options) {
  if (piece.outline.empty()) return std::nullopt;
  PartFit fit;
  const double mm_per_px = scale_mm_per_px(piece, item, focal_px);
  fit.places = places_of(piece, item, mm_per_px);
  const bool in_area =
      std::ranges::any_of(item.areas, [&](const Polygon& area) { return is_in(area, piece.centroid); });
  if (fit.places.empty() && !in_area) return std::nullopt;
  fit.misfit = misfit_of(piece, *item.item, options);
  if (!fit.places.empty() && !is_resolved(piece)) fit.misfit = std::min(fit.misfit, 1.0);
  if (fit.misfit > 1.0) return std::nullopt;
  if (item.depth_m || piece.depth_m) judge_size(piece, item, mm_per_px, fit);
  if (fit.too_large && fit.places.empty()) return std::nullopt;
  return fit;
}

}  // namespace rva
