#include "map/waypoints.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cassert>
#include <nlohmann/json.hpp>
#include <utility>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json_object.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

std::vector<double> angles_deg(const GridAxis& axis) {
  assert(axis.count >= 1);
  std::vector<double> angles;
  for (int i = 0; i < axis.count; ++i) {
    const double share = axis.count == 1 ? 0.0 : static_cast<double>(i) / (axis.count - 1);
    angles.push_back((1.0 - share) * axis.from_deg + share * axis.to_deg);
  }
  return angles;
}

}  // namespace

std::vector<PanTilt> grid_waypoints(const GridAxis& pan, const GridAxis& tilt) {
  std::vector<double> pans_deg = angles_deg(pan);
  std::vector<PanTilt> waypoints;
  for (const double tilt_deg : angles_deg(tilt)) {
    for (const double pan_deg : pans_deg) waypoints.push_back({pan_deg, tilt_deg});
    std::ranges::reverse(pans_deg);
  }
  return waypoints;
}

std::vector<PanTilt> load_waypoints(const std::filesystem::path& path) {
  const std::string file = printable(path);
  const nlohmann::json json = parse_json(read_text_file(path), file);
  const JsonObject object(json, file);
  if (object.optional_string("format") != "rva-waypoints")
    throw Error(file, "is not a list of waypoints", "give one as described in docs/mapping.md");
  if (object.integer("version") != 1)
    throw Error(object.name_of("version"), "is not 1, the only supported version", "use a newer rva");
  if (!object.has("waypoints") || !json["waypoints"].is_array())
    throw Error(object.name_of("waypoints"), "not a list", "correct the file");
  const nlohmann::json& list = json["waypoints"];
  if (list.empty() || std::cmp_greater(list.size(), most_waypoints))
    throw Error(object.name_of("waypoints"), fmt::format("contains {}", list.size()),
                fmt::format("give 1 to {} waypoints", most_waypoints));
  std::vector<PanTilt> waypoints;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const JsonObject waypoint(list[i], file, fmt::format("waypoints[{}]", i));
    waypoints.push_back({waypoint.number("pan_deg"), waypoint.number("tilt_deg")});
  }
  return waypoints;
}

void check_waypoints(const std::vector<PanTilt>& waypoints, const RobotLimits& limits) {
  for (std::size_t i = 0; i < waypoints.size(); ++i) {
    try {
      limits.check(waypoints[i]);
    } catch (const UsageError& error) {
      throw UsageError(fmt::format("waypoint {}", i + 1),
                       fmt::format("{}: {}", error.source(), error.problem()), error.remedy());
    }
  }
}

}  // namespace rva
