#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

#include "core/file.hpp"
#include "core/path_text.hpp"
#include "core/yaml_node.hpp"
#include "plan/plan.hpp"
#include "plan/plan_areas.hpp"

namespace rva {
namespace {

constexpr NumberRange pixels_range{-1e5, 1e5};
constexpr NumberRange metres_range{-100.0, 100.0};
constexpr NumberRange depth_range_m{0.01, 100.0};
constexpr NumberRange length_range_mm{0.1, 10000.0};
constexpr NumberRange tolerance_range_mm{0.1, 1000.0};
constexpr int most_parts = 1000;

PlanPoint read_point(const YamlNode& value, PlanCoordinates coordinates) {
  if (coordinates == PlanCoordinates::pixels) {
    const std::vector<double> pixel = value.numbers(2, pixels_range);
    return {{pixel[0], pixel[1]}, 0.0};
  }
  const std::vector<double> point = value.numbers(3, metres_range);
  const double depth_m = value.items()[2].number(depth_range_m);
  return {{point[0] / depth_m, point[1] / depth_m}, depth_m};
}

std::vector<PlanPoint> read_points(const YamlNode& list, PlanCoordinates coordinates) {
  std::vector<PlanPoint> points;
  for (const YamlNode& point : list.items()) points.push_back(read_point(point, coordinates));
  return points;
}

RangeMm read_range(const YamlNode& value) {
  const std::vector<double> limits = value.numbers(2, length_range_mm);
  if (limits[0] > limits[1])
    throw value.error("the first limit is above the second", "give [least, largest]");
  return {limits[0], limits[1]};
}

std::vector<std::vector<PlanPoint>> read_areas(const YamlNode& list, PlanCoordinates coordinates) {
  std::vector<std::vector<PlanPoint>> areas;
  for (const YamlNode& polygon : list.items()) {
    areas.push_back(read_points(polygon, coordinates));
    if (const std::string fault = fault_of(areas.back()); !fault.empty())
      throw polygon.error(fault, "give its corners in the order in which its border runs");
  }
  return areas;
}

ChangeKind read_kind(const YamlNode& value) {
  constexpr auto kinds = names_of<ChangeKind>();
  return value_of<ChangeKind>(kinds.at(value.choice("kind", kinds))).value();
}

// The number of parts is that of the places where these are given.
int read_count(const YamlNode& part, const std::vector<PlanPoint>& places) {
  const auto places_given = static_cast<int>(places.size());
  const auto count = part.find("count");
  if (!count && places.empty()) throw part.error("neither count nor places", "add the number of parts");
  if (!count) return places_given;
  const int number = count->integer(1, most_parts);
  if (!places.empty() && number != places_given)
    throw count->error(fmt::format("{} parts, but {} places", number, places_given),
                       "correct the count, or give the place of each part");
  return number;
}

PlannedItem read_item(const YamlNode& part, PlanCoordinates coordinates) {
  part.allow_only({"name", "kind", "count", "height_mm", "size_mm", "areas", "places", "tolerance_mm"});
  PlannedItem item;
  item.name = printable(part.at("name").text());
  if (const auto kind = part.find("kind")) item.kind = read_kind(*kind);
  if (const auto areas = part.find("areas")) item.areas = read_areas(*areas, coordinates);
  if (const auto places = part.find("places")) item.places = read_points(*places, coordinates);
  if (item.areas.empty() && item.places.empty())
    throw part.error("neither areas nor places", "state where the parts will be");
  item.count = read_count(part, item.places);
  // What the images alone show has no height.
  if (item.kind != ChangeKind::appearance || part.has("height_mm"))
    item.height_mm = read_range(part.at("height_mm"));
  if (const auto size = part.find("size_mm")) item.size_mm = read_range(*size);
  part.read("tolerance_mm", item.tolerance_mm, tolerance_range_mm);
  return item;
}

// In pixels, a distance on the picture is no distance in millimetres: only equal places are refused there.
double least_distance(const PlannedItem& a, const PlannedItem& b, PlanCoordinates coordinates) {
  return coordinates == PlanCoordinates::pixels ? 1.0 : std::min(a.tolerance_mm, b.tolerance_mm);
}

void require_clear_places(const PlannedItem& a, const PlannedItem& b, const YamlNode& part,
                          PlanCoordinates coordinates) {
  const double least = least_distance(a, b, coordinates);
  const bool is_one = &a == &b;
  for (std::size_t i = 0; i < a.places.size(); ++i) {
    for (std::size_t k = is_one ? i + 1 : 0; k < b.places.size(); ++k) {
      if (distance_between(a.places[i], b.places[k], coordinates) >= least) continue;
      throw part.error(fmt::format("place {} is too near to place {} of {}: a part could be at either", k + 1,
                                   i + 1, a.name),
                       "remove one of them, or give a smaller tolerance_mm");
    }
  }
}

// Refuses what two entries, or one with itself, contradict each other in.
void require_compatible(const PlannedItem& earlier, const PlannedItem& item, const YamlNode& part,
                        PlanCoordinates coordinates) {
  const bool is_one = &earlier == &item;
  if (!is_one && earlier.name == item.name)
    throw part.at("name").error("another entry has this name", "give each entry a name of its own");
  if (earlier.kind != item.kind) return;
  require_clear_places(earlier, item, part, coordinates);
  if (!is_one && overlap(earlier, item))
    throw part.at("areas").error(fmt::format("overlaps an area of {}", earlier.name),
                                 "draw the areas of one kind apart from each other");
}

}  // namespace

Plan parse_plan(const std::string& text, const std::string& source) {
  const YamlNode file = YamlNode::parse(text, source);
  file.allow_only({"format", "version", "coordinates", "parts"});
  if (file.at("format").text() != "rva-plan") throw file.at("format").error("not a plan", "use rva-plan");
  (void)file.at("version").integer(1, 1);
  Plan plan;
  if (const auto coordinates = file.find("coordinates")) {
    constexpr auto names = names_of<PlanCoordinates>();
    plan.coordinates = value_of<PlanCoordinates>(names.at(coordinates->choice("coordinates", names))).value();
  }
  for (const YamlNode& part : file.at("parts").items()) {
    plan.items.push_back(read_item(part, plan.coordinates));
    for (const PlannedItem& earlier : plan.items)
      require_compatible(earlier, plan.items.back(), part, plan.coordinates);
  }
  if (plan.items.empty()) throw file.at("parts").error("empty", "add the parts of the work order");
  return plan;
}

Plan read_plan(const std::filesystem::path& file) {
  return parse_plan(read_text_file(file), printable(file));
}

}  // namespace rva
