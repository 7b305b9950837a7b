#include "core/json_object.hpp"
#include "server/api.hpp"
#include "server/request_body.hpp"

namespace rva {

// Captures of one task have one exposure: it stays while a task is running.
ApiResponse Api::set_exposure(const Call& call) const {
  Exposure exposure{.automatic = flag_field(call.body, "automatic")};
  if (!exposure.automatic) {
    exposure.time_us = number_field(call.body, "time_us");
    exposure.gain = number_field(call.body, "gain");
  }
  if (parts_.inspector.task().end == TaskEnd::running)
    throw Error("exposure", "cannot be changed while the camera is being used", "wait until the task ends");
  parts_.camera.set_exposure(exposure);
  return {200, "application/json", json_text(Json::object())};
}

}  // namespace rva
