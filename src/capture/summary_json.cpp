#include <nlohmann/json.hpp>

#include "capture/capture_summary.hpp"
#include "capture/intrinsics_json.hpp"

namespace rva {
namespace {

using Json = nlohmann::ordered_json;

Json json_of(const Pose& pose) {
  Json json = Json::object();
  if (pose.base) json["base"] = *pose.base;
  if (pose.pan_deg) json["pan_deg"] = *pose.pan_deg;
  if (pose.tilt_deg) json["tilt_deg"] = *pose.tilt_deg;
  if (pose.world_from_camera) json["world_from_camera"] = to_row_major(*pose.world_from_camera);
  if (pose.off_baseline_deg) json["off_baseline_deg"] = *pose.off_baseline_deg;
  if (pose.approaches) json["approaches"] = *pose.approaches;
  return json;
}

}  // namespace

Json json_of(const Capture& capture, const CaptureSummary& summary) {
  const CaptureInfo& info = capture.info();
  Json json{{"format", info.format},
            {"sound", true},
            {"depth_frames", capture.depth_frames()},
            {"color_frames", capture.color_frames()}};
  json["depth"] = json_of(info.depth);
  json["depth"]["unit_m"] = info.depth_unit_m;
  if (info.color) json["color"] = json_of(*info.color);
  if (info.color_from_depth) json["color_from_depth"] = to_row_major(*info.color_from_depth);
  if (info.pose) json["pose"] = json_of(*info.pose);
  if (info.camera) {
    json["camera"] = {{"model", info.camera->model}, {"serial", info.camera->serial}};
    if (info.camera->baseline_m) json["camera"]["baseline_m"] = *info.camera->baseline_m;
    if (!info.camera->firmware.empty()) json["camera"]["firmware"] = info.camera->firmware;
    if (!info.camera->usb.empty()) json["camera"]["usb"] = info.camera->usb;
    if (!info.camera->settings.empty()) json["camera"]["settings"] = info.camera->settings;
  }
  if (!info.captured_at.empty()) json["captured_at"] = info.captured_at;
  json["fill_rate"] = summary.fill_rate;
  json["nearest_m"] = summary.nearest_m;
  json["farthest_m"] = summary.farthest_m;
  json["lost_frames"] = summary.lost;
  if (!summary.notes.empty()) json["notes"] = summary.notes;
  return json;
}

}  // namespace rva
