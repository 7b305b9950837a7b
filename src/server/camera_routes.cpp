#include <cmath>

#include "core/error.hpp"
#include "core/json_object.hpp"
#include "server/api.hpp"
#include "server/request_body.hpp"

namespace rva {

// All captures of a side have one exposure and one light: they stay while these are taken.
void Api::require_no_capture(const std::string& what) const {
  const TaskState task = parts_.inspector.task();
  if (task.end == TaskEnd::running && task.kind == TaskKind::capture)
    throw Error(what, "cannot be changed during a capture", "wait until it ends, or cancel it");
}

ApiResponse Api::set_exposure(const Call& call) const {
  Exposure exposure{.automatic = flag_field(call.body, "automatic")};
  if (!exposure.automatic) {
    exposure.time_us = number_field(call.body, "time_us");
    exposure.gain = number_field(call.body, "gain");
  }
  require_no_capture("exposure");
  parts_.camera.set_exposure(exposure);
  return {200, "application/json", json_text(Json::object())};
}

ApiResponse Api::set_lamp(const Call& call) const {
  constexpr double most_percent = 100.0;
  const double percent = number_field(call.body, "percent");
  if (percent != std::floor(percent) || std::abs(percent) > most_percent)
    throw UsageError("percent", "is not a whole number from 0 to 100", "give one");
  if (parts_.drive == nullptr)
    throw Error("lamp", "there is no robot that has one", "start the server with a robot");
  require_no_capture("lamp");
  parts_.drive->set_lamp(static_cast<int>(percent));
  return {200, "application/json", json_text(Json::object())};
}

}  // namespace rva
