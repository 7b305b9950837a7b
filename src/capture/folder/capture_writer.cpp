#include "capture/folder/capture_writer.hpp"

#include <fmt/format.h>

#include <cassert>
#include <nlohmann/json.hpp>
#include <optional>
#include <system_error>
#include <utility>

#include "capture/formats.hpp"
#include "capture/intrinsics_json.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json_object.hpp"
#include "core/path_text.hpp"
#include "depth/image_file.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

using Json = nlohmann::ordered_json;

// Null stands for an unknown value: the merge in json_of(CaptureInfo) removes such keys (RFC 7396).
Json or_null(const std::string& text) { return text.empty() ? Json() : Json(text); }

template <typename Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

Json or_null(const std::optional<Transform>& a_from_b) {
  return a_from_b ? Json(to_row_major(*a_from_b)) : Json();
}

Json json_of(const Pose& pose) {
  return {{"base", or_null(pose.base)},
          {"pan_deg", or_null(pose.pan_deg)},
          {"tilt_deg", or_null(pose.tilt_deg)},
          {"world_from_camera", or_null(pose.world_from_camera)},
          {"off_baseline_deg", or_null(pose.off_baseline_deg)},
          {"approaches", or_null(pose.approaches)}};
}

Json json_of(const CameraInfo& camera) {
  return {{"model", or_null(camera.model)},
          {"serial", or_null(camera.serial)},
          {"baseline_m", or_null(camera.baseline_m)},
          {"firmware", or_null(camera.firmware)},
          {"usb", or_null(camera.usb)},
          {"settings", camera.settings.empty() ? Json() : Json(camera.settings)}};
}

Json json_of(const InfraredBurst& burst) {
  return {{"scale", burst.per_grey_level},
          {"frames", burst.frames},
          {"exposure_us", or_null(burst.exposure_us)},
          {"gain", or_null(burst.gain)},
          {"laser_power_mw", or_null(burst.laser_power_mw)}};
}

template <typename Pixel, typename Meaning>
void require_size(const fs::path& file, const Image<Pixel, Meaning>& image, const Intrinsics& stated) {
  if (image.width() == stated.width && image.height() == stated.height) return;
  throw Error(printable(file),
              fmt::format("the image has {}x{} pixels, but the capture states {}x{}", image.width(),
                          image.height(), stated.width, stated.height),
              "record the capture again");
}

fs::path frame_file(const fs::path& folder, const fs::path& kind, std::size_t number) {
  assert(number <= 999999);
  return folder / kind / fmt::format("{:06}.png", number);
}

template <typename Pixel, typename Meaning>
void write_image(const fs::path& file, const Image<Pixel, Meaning>& image) {
  std::error_code ignored;  // if the folder is missing, put_file() fails and reports why
  fs::create_directories(file.parent_path(), ignored);
  put_file(file, encode_png(image));
}

}  // namespace

Json json_of(const CaptureInfo& info, const std::string& extra_json_object) {
  const std::string source = "the capture's extra keys";
  const nlohmann::json extra = parse_json(extra_json_object, source);
  static_cast<void>(JsonObject(extra, source));
  Json known{{"format", "rva-capture"}, {"version", 1}};
  Json document = known;
  document.update(Json(extra));
  known["depth"] = json_of(info.depth);
  known["depth"]["unit_m"] = info.depth_unit_m;
  known["color"] = info.color ? json_of(*info.color) : Json();
  known["color_from_depth"] = or_null(info.color_from_depth);
  known["pose"] = info.pose ? json_of(*info.pose) : Json();
  known["camera"] = info.camera ? json_of(*info.camera) : Json();
  known["infrared"] = info.infrared ? json_of(*info.infrared) : Json();
  known["lamp"] = info.lamp ? json_of(*info.lamp) : Json();
  known["captured_at"] = or_null(info.captured_at);
  document.merge_patch(known);
  return document;
}

std::string frame_line(std::size_t number, const FrameMetadata& metadata) {
  const Json known{{"counter", or_null(metadata.counter)},
                   {"time_s", or_null(metadata.time_s)},
                   {"exposure_us", or_null(metadata.exposure_us)},
                   {"gain", or_null(metadata.gain)},
                   {"laser_power_mw", or_null(metadata.laser_power_mw)},
                   {"temperature_c", or_null(metadata.temperature_c)}};
  Json line{{"frame", number}};
  line.merge_patch(known);
  return json_text(line) + "\n";
}

std::vector<std::string> capture_files() {
  const std::string frame = "[0-9][0-9][0-9][0-9][0-9][0-9].png";
  std::vector<std::string> files{"capture.json", "depth/" + frame, "color/" + frame, "frames.jsonl"};
  for (const Imager imager : both_imagers) {
    for (const Light light : {Light::projector, Light::lamp})
      files.push_back((infrared_folder(imager, light) / frame).string());
  }
  return files;
}

fs::path infrared_folder(Imager imager, Light light) {
  const fs::path name = imager == Imager::left ? "infrared" : "infrared_right";
  return light == Light::lamp ? "lamp" / name : name;
}

CaptureWriter::CaptureWriter(fs::path folder, const CaptureInfo& info, const std::string& extra_json_object)
    : folder_(std::move(folder)), info_(info), extra_json_object_(extra_json_object) {
  info_.infrared.reset();
  info_.lamp.reset();
  const fs::path file = folder_ / "capture.json";
  const std::string description = json_file_text(json_of(info_, extra_json_object_));
  require_possible(parse_capture_json(description, printable(file)), printable(folder_));
  write_file(file, description);
}

void CaptureWriter::write_depth(std::size_t number, const DepthImage& image) {
  const fs::path file = frame_file(folder_, "depth", number);
  require_size(file, image, info_.depth);
  write_image(file, image);
}

void CaptureWriter::write_color(std::size_t number, const ColorImage& image) {
  const fs::path file = frame_file(folder_, "color", number);
  if (info_.color) require_size(file, image, *info_.color);
  write_image(file, image);
}

void CaptureWriter::write_infrared(Imager imager, Light light, const FineGrayImage& mean,
                                   const InfraredBurst& burst) {
  const fs::path file = frame_file(folder_, infrared_folder(imager, light), 0);
  require_size(file, mean, info_.depth);
  (light == Light::lamp ? info_.lamp : info_.infrared) = burst;
  replace_file(folder_ / "capture.json", json_file_text(json_of(info_, extra_json_object_)));
  write_image(file, mean);
}

void CaptureWriter::write_metadata(std::size_t number, const FrameMetadata& metadata) {
  append_to_file(folder_ / "frames.jsonl", frame_line(number, metadata));
}

}  // namespace rva
