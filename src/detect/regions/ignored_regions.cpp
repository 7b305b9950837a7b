#include "detect/regions/ignored_regions.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <span>
#include <string_view>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json_object.hpp"
#include "core/options.hpp"
#include "core/path_text.hpp"
#include "depth/image_file.hpp"

namespace rva {
namespace {

constexpr std::string_view format_name = "rva-regions";
constexpr const char* correct_it = "correct the file (docs/detection.md shows one)";

// True if the point is inside or on an edge, by the parity of the edges that a ray to the right crosses.
bool contains(const Polygon& polygon, const Eigen::Vector2d& point) {
  bool inside = false;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Eigen::Vector2d& a = polygon[i];
    const Eigen::Vector2d& b = polygon[(i + 1) % polygon.size()];
    const Eigen::Vector2d edge = b - a;
    const Eigen::Vector2d off = point - a;
    const double along = edge.dot(off);
    if (edge.x() * off.y() == edge.y() * off.x() && along >= 0.0 && along <= edge.squaredNorm()) return true;
    if ((a.y() > point.y()) == (b.y() > point.y())) continue;
    if (point.x() < a.x() + edge.x() * (point.y() - a.y()) / edge.y()) inside = !inside;
  }
  return inside;
}

int within_image(double pixel, int size) {
  return static_cast<int>(std::clamp(pixel, -1.0, static_cast<double>(size)));
}

void fill(const Polygon& polygon, Mask& mask) {
  Eigen::Vector2d low = polygon.front();
  Eigen::Vector2d high = low;
  for (const Eigen::Vector2d& corner : polygon) {
    low = low.cwiseMin(corner);
    high = high.cwiseMax(corner);
  }
  const int top = std::max(0, within_image(std::ceil(low.y()), mask.height()));
  const int bottom = std::min(mask.height() - 1, within_image(std::floor(high.y()), mask.height()));
  const int left = std::max(0, within_image(std::ceil(low.x()), mask.width()));
  const int right = std::min(mask.width() - 1, within_image(std::floor(high.x()), mask.width()));
  for (int v = top; v <= bottom; ++v) {
    for (int u = left; u <= right; ++u) {
      if (contains(polygon, Eigen::Vector2d(u, v))) mask(u, v) = mask_set;
    }
  }
}

Mask filled(const std::vector<Polygon>& polygons, int width, int height) {
  Mask mask(width, height);
  for (const Polygon& polygon : polygons) fill(polygon, mask);
  return mask;
}

Polygon parse_polygon(const nlohmann::json& value, const std::string& source) {
  if (!value.is_array() || value.size() < 3 || value.size() > most_corners)
    throw Error(source, fmt::format("is not a list of 3 to {} corners", most_corners), correct_it);
  Polygon polygon;
  for (const nlohmann::json& corner : value) {
    if (!corner.is_array() || corner.size() != 2 || !corner[0].is_number() || !corner[1].is_number())
      throw Error(source, "has a corner that is not a pair of numbers", correct_it);
    polygon.emplace_back(corner[0].get<double>(), corner[1].get<double>());
    constexpr double far_px = 1e6;
    if (!(polygon.back().cwiseAbs().maxCoeff() <= far_px))
      throw Error(source, "has a corner that lies outside any image", correct_it);
  }
  return polygon;
}

std::vector<Polygon> parse_polygons(const nlohmann::json& document, const char* key,
                                    const std::string& source) {
  const auto found = document.find(key);
  if (found == document.end() || found->is_null()) return {};
  if (!found->is_array() || found->size() > most_polygons)
    throw Error(fmt::format("{}: {}", source, key),
                fmt::format("is not a list of up to {} polygons", most_polygons), correct_it);
  std::vector<Polygon> polygons;
  for (std::size_t i = 0; i < found->size(); ++i)
    polygons.push_back(parse_polygon((*found)[i], fmt::format("{}: {}[{}]", source, key, i)));
  return polygons;
}

nlohmann::json json_of(const std::vector<Polygon>& polygons) {
  nlohmann::json list = nlohmann::json::array();
  for (const Polygon& polygon : polygons) {
    nlohmann::json corners = nlohmann::json::array();
    for (const Eigen::Vector2d& corner : polygon) corners.push_back({corner.x(), corner.y()});
    list.push_back(std::move(corners));
  }
  return list;
}

Mask mask_from_picture(const std::filesystem::path& file, int width, int height) {
  const ColorImage picture = read_color(file);
  if (picture.width() != width || picture.height() != height)
    throw Error(printable(file),
                fmt::format("has {}x{} pixels where the depth image has {}x{}", picture.width(),
                            picture.height(), width, height),
                "draw the mask at the size of the initial depth image");
  Mask mask(width, height);
  std::ranges::transform(picture.pixels(), mask.pixels().begin(),
                         [](const Rgb& pixel) { return pixel == Rgb{} ? std::uint8_t{0} : mask_set; });
  return mask;
}

bool looks_like_json(const std::string& text) {
  const auto first = text.find_first_not_of(" \t\r\n");
  return first != std::string::npos && text[first] == '{';
}

}  // namespace

Mask mask_of(const IgnoredRegions& regions, int width, int height) {
  if (regions.empty()) return {};
  Mask mask = filled(regions.ignore, width, height);
  if (regions.within.empty()) return mask;
  const Mask kept = filled(regions.within, width, height);
  for (std::size_t i = 0; i < mask.size(); ++i) {
    if (kept[i] == 0) mask[i] = mask_set;
  }
  return mask;
}

Polygon polygon_of(const Box& box) {
  constexpr double half = 0.5;
  const double left = box.x - half;
  const double top = box.y - half;
  const double right = left + box.width;
  const double bottom = top + box.height;
  return {{left, top}, {right, top}, {right, bottom}, {left, bottom}};
}

void add_within(IgnoredRegions& regions, const Box& box, int width, int height) {
  if (box.width < 1 || box.height < 1 || box.x >= width || box.y >= height || box.x + box.width <= 0 ||
      box.y + box.height <= 0)
    throw OptionError("within",
                      fmt::format("{},{},{},{} contains no pixel of the depth image of {}x{}", box.x, box.y,
                                  box.width, box.height, width, height),
                      "give x,y,w,h in pixels of the initial depth image");
  regions.within.push_back(polygon_of(box));
}

IgnoredRegions parse_regions(const std::string& text, const std::string& source) {
  const nlohmann::json document = parse_json(text, source);
  const JsonObject object(document, source);
  if (object.optional_string("format") != format_name || object.optional_number("version") != 1.0)
    throw Error(source, fmt::format("is not a {} file of version 1", format_name), correct_it);
  return {parse_polygons(document, "ignore", source), parse_polygons(document, "within", source)};
}

nlohmann::ordered_json json_of(const IgnoredRegions& regions) {
  nlohmann::ordered_json json{{"format", format_name}, {"version", 1}};
  json["ignore"] = json_of(regions.ignore);
  json["within"] = json_of(regions.within);
  return json;
}

Mask read_ignored_mask(const std::filesystem::path& file, int width, int height) {
  const std::string text = read_text_file(file);
  if (!looks_like_json(text)) return mask_from_picture(file, width, height);
  return mask_of(parse_regions(text, printable(file)), width, height);
}

void unite(Mask& mask, const Mask& more) {
  if (mask.empty()) mask = Mask(more.width(), more.height());
  for (std::size_t i = 0; i < more.size(); ++i) {
    if (more[i] != 0) mask[i] = mask_set;
  }
}

}  // namespace rva
