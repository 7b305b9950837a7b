#include "server/status.hpp"

#include <cmath>

#include "core/json_object.hpp"
#include "server/json_of.hpp"
#include "server/private_paths.hpp"

namespace rva {
namespace {

Json json_of(const ExposureControl& control) {
  return {{"automatic", control.set.automatic},
          {"time_us", control.set.time_us},
          {"gain", control.set.gain},
          {"time_range_us", {control.time_us.least, control.time_us.greatest}},
          {"gain_range", {control.gain.least, control.gain.greatest}}};
}

Json json_of(const LiveCamera& camera, const LivePictures& pictures) {
  const CameraHealth health = camera.health();
  Json json{{"rate_hz", std::round(10.0 * health.rate_hz) / 10.0}, {"lost", health.lost}};
  if (!health.problem.empty()) json["problem"] = without_folders(health.problem);
  json["streams"] = Json::array();
  for (const Stream stream : pictures.streams()) json["streams"].push_back(name_of(stream));
  if (const auto live = camera.newest()) {
    json["model"] = live->info.camera.value_or(CameraInfo{}).model;
    json["width"] = live->info.depth.width;
    json["height"] = live->info.depth.height;
  }
  if (const auto control = camera.exposure_control()) json["exposure"] = json_of(*control);
  return json;
}

}  // namespace

std::string status_message(const ServerParts& parts, const LivePictures& pictures, std::size_t consoles) {
  Json json{{"type", "status"}, {"camera", json_of(parts.camera, pictures)}};
  if (parts.drive != nullptr) json["robot"] = json_of(parts.drive->state(), parts.drive->limits());
  json["task"] = json_of(parts.inspector.task());
  if (const auto readiness = parts.inspector.readiness()) json["readiness"] = json_of(*readiness);
  json["consoles"] = consoles;
  json["simulation"] = static_cast<bool>(parts.simulated_work);
  return json_text(json);
}

}  // namespace rva
