#include <nlohmann/json.hpp>

#include "plan/plan.hpp"

namespace rva {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const PlanPoint& point, PlanCoordinates coordinates) {
  if (coordinates == PlanCoordinates::pixels) return {point.at.x(), point.at.y()};
  return {point.at.x() * point.depth_m, point.at.y() * point.depth_m, point.depth_m};
}

Json json_of(const std::vector<PlanPoint>& points, PlanCoordinates coordinates) {
  Json list = Json::array();
  for (const PlanPoint& point : points) list.push_back(json_of(point, coordinates));
  return list;
}

Json json_of(const PlannedItem& item, PlanCoordinates coordinates) {
  Json json{{"name", item.name}, {"kind", name_of(item.kind)}, {"count", item.count}};
  if (item.height_mm != RangeMm{}) json["height_mm"] = {item.height_mm.low, item.height_mm.high};
  if (item.size_mm) json["size_mm"] = {item.size_mm->low, item.size_mm->high};
  json["areas"] = Json::array();
  for (const std::vector<PlanPoint>& area : item.areas) json["areas"].push_back(json_of(area, coordinates));
  if (!item.places.empty()) json["places"] = json_of(item.places, coordinates);
  json["tolerance_mm"] = item.tolerance_mm;
  return json;
}

}  // namespace

Json json_of(const Plan& plan) {
  Json json{{"format", "rva-plan"}, {"version", 1}, {"coordinates", name_of(plan.coordinates)}};
  json["parts"] = Json::array();
  for (const PlannedItem& item : plan.items) json["parts"].push_back(json_of(item, plan.coordinates));
  return json;
}

}  // namespace rva
