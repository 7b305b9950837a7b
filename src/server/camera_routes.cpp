#include "core/json_object.hpp"
#include "server/api.hpp"
#include "server/request_body.hpp"

namespace rva {

// All captures of a side have one exposure: it stays while they are taken.
ApiResponse Api::set_exposure(const Call& call) const {
  Exposure exposure{.automatic = flag_field(call.body, "automatic")};
  if (!exposure.automatic) {
    exposure.time_us = number_field(call.body, "time_us");
    exposure.gain = number_field(call.body, "gain");
  }
  const TaskState task = parts_.inspector.task();
  if (task.end == TaskEnd::running && task.kind == TaskKind::capture)
    throw Error("exposure", "cannot be changed during a capture", "wait until it ends, or cancel it");
  parts_.camera.set_exposure(exposure);
  return {200, "application/json", json_text(Json::object())};
}

}  // namespace rva
