#include "plan/plan_areas.hpp"

#include <algorithm>
#include <boost/geometry.hpp>
#include <boost/geometry/geometries/point_xy.hpp>
#include <boost/geometry/geometries/polygon.hpp>

#include "core/units.hpp"

namespace rva {
namespace {

namespace bg = boost::geometry;
using Corner = bg::model::d2::point_xy<double>;
using Outline = bg::model::polygon<Corner>;

Outline outline_of(const std::vector<PlanPoint>& polygon) {
  Outline outline;
  for (const PlanPoint& point : polygon) bg::append(outline, Corner(point.at.x(), point.at.y()));
  bg::correct(outline);
  return outline;
}

// Areas that were drawn side by side may share a little of their border, by rounding.
bool overlap(const std::vector<PlanPoint>& a, const std::vector<PlanPoint>& b) {
  constexpr double least_share = 1e-3;
  const Outline first = outline_of(a);
  const Outline second = outline_of(b);
  std::vector<Outline> common;
  bg::intersection(first, second, common);
  double area = 0.0;
  for (const Outline& piece : common) area += bg::area(piece);
  return area > least_share * std::min(bg::area(first), bg::area(second));
}

}  // namespace

std::string fault_of(const std::vector<PlanPoint>& polygon) {
  constexpr std::size_t least_corners = 3;
  if (polygon.size() < least_corners) return "a polygon of fewer than three corners";
  if (!bg::is_valid(outline_of(polygon))) return "the border of the polygon crosses or touches itself";
  return {};
}

bool overlap(const PlannedItem& a, const PlannedItem& b) {
  return std::ranges::any_of(a.areas, [&](const auto& first) {
    return std::ranges::any_of(b.areas, [&](const auto& second) { return overlap(first, second); });
  });
}

double distance_between(const PlanPoint& a, const PlanPoint& b, PlanCoordinates coordinates) {
  if (coordinates == PlanCoordinates::pixels) return (a.at - b.at).norm();
  return mm_per_m * (a.depth_m * a.at.homogeneous() - b.depth_m * b.at.homogeneous()).norm();
}

}  // namespace rva
