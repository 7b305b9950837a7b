#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <nlohmann/json.hpp>
#include <sstream>
#include <system_error>

#include "capture/capture_view.hpp"
#include "capture/formats.hpp"
#include "capture/images/depth_file.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json_object.hpp"
#include "core/path_text.hpp"
#include "core/units.hpp"
#include "depth/image_file.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

Intrinsics parse_intrinsics(const JsonObject& object) {
  Intrinsics camera;
  camera.width = object.integer("width");
  camera.height = object.integer("height");
  camera.fx = object.number("fx");
  camera.fy = object.number("fy");
  camera.cx = object.number("cx");
  camera.cy = object.number("cy");
  if (const auto name = object.optional_string("distortion_model")) {
    const auto model = value_of<Distortion>(*name);
    if (!model) {
      throw Error(object.name_of("distortion_model"),
                  fmt::format("the model '{}' is unknown", printable(*name)),
                  "use none, brown_conrady or inverse_brown_conrady");
    }
    camera.distortion = *model;
  }
  if (object.has("distortion"))
    std::ranges::copy(object.numbers("distortion", 5), camera.coefficients.begin());
  try {
    camera.check();
  } catch (const Error& error) {
    throw Error(object.name_of(error.source()), error.problem(), "correct the file");
  }
  return camera;
}

Transform parse_transform(const JsonObject& object, const char* key) {
  const std::vector<double> numbers = object.numbers(key, 16);
  try {
    return from_row_major(std::span<const double, 16>(numbers));
  } catch (const Error& error) {
    throw Error(object.name_of(key), error.problem(), error.remedy());
  }
}

Pose parse_pose(const JsonObject& object) {
  Pose pose;
  pose.base = object.optional_string("base");
  pose.pan_deg = object.optional_number("pan_deg");
  pose.tilt_deg = object.optional_number("tilt_deg");
  pose.off_baseline_deg = object.optional_number("off_baseline_deg");
  if (const auto approaches = object.optional_number("approaches"))
    pose.approaches = static_cast<int>(*approaches);
  if (object.has("world_from_camera")) pose.world_from_camera = parse_transform(object, "world_from_camera");
  return pose;
}

CameraInfo parse_camera(const JsonObject& object) {
  CameraInfo camera{.model = object.optional_string("model").value_or(""),
                    .serial = object.optional_string("serial").value_or(""),
                    .baseline_m = object.optional_number("baseline_m"),
                    .firmware = object.optional_string("firmware").value_or(""),
                    .usb = object.optional_string("usb").value_or("")};
  const auto settings = object.optional_object("settings");
  if (!settings) return camera;
  for (const std::string& imager : settings->keys()) {
    const JsonObject of_imager = settings->object(imager.c_str());
    for (const std::string& name : of_imager.keys())
      camera.settings[imager][name] = of_imager.number(name.c_str());
  }
  return camera;
}

InfraredBurst parse_infrared(const JsonObject& object, double usual_scale) {
  constexpr double most_counts = 65535.0;
  constexpr double most_frames = 1e6;
  InfraredBurst burst;
  burst.per_grey_level = object.optional_number("scale").value_or(usual_scale);
  const double frames = object.optional_number("frames").value_or(1.0);
  if (!(frames >= 1.0 && frames <= most_frames))
    throw Error(object.name_of("frames"), "not a number of frames from 1 to a million", "correct the file");
  burst.frames = static_cast<int>(frames);
  if (!(burst.per_grey_level > 0.0 && burst.per_grey_level <= most_counts))
    throw Error(object.name_of("scale"), "not a number of counts above 0 and up to 65535",
                "correct the file");
  burst.exposure_us = object.optional_number("exposure_us");
  burst.gain = object.optional_number("gain");
  burst.laser_power_mw = object.optional_number("laser_power_mw");
  return burst;
}

// Keeps the images of frames: others may lie beside them, such as the last image of one imager.
std::vector<fs::path> numbered(std::vector<fs::path> files) {
  const auto is_digit = [](char letter) { return letter >= '0' && letter <= '9'; };
  std::erase_if(files,
                [&](const fs::path& file) { return !std::ranges::all_of(file.stem().native(), is_digit); });
  return files;
}

// Refuses impossible sizes before memory is allocated for an image.
void require_possible_size(const std::string& source, const Intrinsics& camera, long most_pixels) {
  if (camera.width <= most_pixels / camera.height) return;
  throw Error(
      source,
      fmt::format("states images of {}x{} pixels, larger than any camera gives", camera.width, camera.height),
      "correct the description");
}

// Detects a transposed matrix, or one of another image size. Imagers have nearly square pixels and sit nearly
// centred behind their lenses; the principal point of a cropped image may be off by half of its size.
void require_plausible(const std::string& source, const Intrinsics& camera) {
  constexpr double most_ratio = 2.0;
  const double ratio = camera.fx / camera.fy;
  const auto refuse = [&](const std::string& problem) {
    throw Error(source, problem, "correct the intrinsics: fx, fy, cx and cy in pixels of the depth images");
  };
  if (ratio > most_ratio || ratio < 1.0 / most_ratio)
    refuse(fmt::format("no camera has focal lengths fx {:.6g} and fy {:.6g}", camera.fx, camera.fy));
  if (std::abs(camera.cx / camera.width - 0.5) >= 1.0 || std::abs(camera.cy / camera.height - 0.5) >= 1.0 ||
      (camera.cx == 0.0 && camera.cy == 0.0))
    refuse(
        fmt::format("the principal point cx {:.6g}, cy {:.6g} lies far from the middle of an image of {}x{}",
                    camera.cx, camera.cy, camera.width, camera.height));
}

void require_format(const JsonObject& document, const std::string& source) {
  if (document.string("format") != "rva-capture") {
    throw Error(source, "the format is not 'rva-capture'", "give the description of a capture");
  }
  if (const int version = document.integer("version"); version != 1) {
    throw Error(source, fmt::format("version {} of the format is not supported", version), "use a newer rva");
  }
}

std::vector<std::uint16_t> parse_no_depth(const nlohmann::json& list, const JsonObject& depth) {
  constexpr std::size_t most_values = 16;
  const auto is_value = [](const nlohmann::json& value) {
    return value.is_number_integer() && value.get<std::int64_t>() >= 0 && value.get<std::int64_t>() <= 65535;
  };
  if (!list.is_array() || list.size() > most_values || !std::ranges::all_of(list, is_value))
    throw Error(depth.name_of("no_depth"),
                fmt::format("not a list of up to {} values of 16 bits", most_values),
                "correct the file, as in [65535]");
  return list.get<std::vector<std::uint16_t>>();
}

}  // namespace

CaptureInfo parse_capture_json(const std::string& text, const std::string& source) {
  const nlohmann::json json = parse_json(text, source);
  const JsonObject document(json, source);
  require_format(document, source);
  CaptureInfo info;
  info.format = "rva-capture";
  info.source_json = text;
  const JsonObject depth = document.object("depth");
  info.depth = parse_intrinsics(depth);
  info.depth_unit_m = depth.number("unit_m");
  if (depth.has("no_depth")) info.no_depth = parse_no_depth(json.at("depth").at("no_depth"), depth);
  if (const auto color = document.optional_object("color")) info.color = parse_intrinsics(*color);
  if (document.has("color_from_depth")) info.color_from_depth = parse_transform(document, "color_from_depth");
  if (const auto pose = document.optional_object("pose")) info.pose = parse_pose(*pose);
  if (const auto camera = document.optional_object("camera")) {
    info.camera = parse_camera(*camera);
  }
  if (const auto infrared = document.optional_object("infrared"))
    info.infrared = parse_infrared(*infrared, InfraredBurst{}.per_grey_level);
  if (const auto lamp = document.optional_object("lamp"))
    info.lamp = parse_infrared(*lamp, info.infrared.value_or(InfraredBurst{}).per_grey_level);
  info.captured_at = document.optional_string("captured_at").value_or("");
  return info;
}

std::map<std::size_t, FrameMetadata> parse_frame_lines(const std::string& text, const std::string& source) {
  std::map<std::size_t, FrameMetadata> frames;
  std::istringstream lines(text);
  std::string line;
  for (int number = 1; std::getline(lines, line) && !lines.eof(); ++number) {
    const std::string where = fmt::format("{}:{}", source, number);
    const nlohmann::json json = parse_json(line, where);
    const JsonObject object(json, where);
    const int frame = object.integer("frame");
    if (frame < 0) throw Error(object.name_of("frame"), "is negative", "correct the file");
    FrameMetadata& metadata = frames[static_cast<std::size_t>(frame)];
    if (const auto counter = object.optional_number("counter"); counter && *counter >= 0 && *counter < 1e18)
      metadata.counter = static_cast<std::uint64_t>(*counter);
    metadata.time_s = object.optional_number("time_s");
    metadata.exposure_us = object.optional_number("exposure_us");
    metadata.gain = object.optional_number("gain");
    metadata.laser_power_mw = object.optional_number("laser_power_mw");
    metadata.temperature_c = object.optional_number("temperature_c");
  }
  return frames;
}

std::unique_ptr<Capture> open_capture_folder(const fs::path& folder, const CaptureOptions& options) {
  const fs::path description = folder / "capture.json";
  const fs::path lines = folder / "frames.jsonl";
  std::error_code ignored;
  FrameFiles files{depth_files(folder / "depth"), image_files(folder / "color", {".png", ".jpg", ".jpeg"})};
  for (const Imager imager : both_imagers) {
    for (const Light light : {Light::projector, Light::lamp})
      files.infrared[{imager, light}] =
          numbered(image_files(folder / infrared_folder(imager, light), {".png"}));
  }
  if (fs::exists(lines, ignored)) files.metadata = parse_frame_lines(read_text_file(lines), printable(lines));
  CaptureInfo info = parse_capture_json(read_text_file(description), printable(description));
  info.no_depth.insert(info.no_depth.end(), options.no_depth.begin(), options.no_depth.end());
  settle_unit(options, info);
  return std::make_unique<FolderCapture>(folder, std::move(info), std::move(files));
}

void settle_unit(const CaptureOptions& options, CaptureInfo& info) {
  if (!options.depth_unit_m) {
    if (info.unit_is_assumed)
      info.notes.push_back(
          fmt::format("the files do not state their depth unit: steps of {:.6g} mm are assumed",
                      mm_per_m * info.depth_unit_m));
    return;
  }
  if (!info.unit_is_assumed && !is_same_unit(info.depth_unit_m, *options.depth_unit_m))
    info.notes.push_back(
        fmt::format("the files state depth in steps of {:.6g} mm; {:.6g} mm were given instead",
                    mm_per_m * info.depth_unit_m, mm_per_m * *options.depth_unit_m));
  info.depth_unit_m = *options.depth_unit_m;
  info.unit_is_assumed = false;
}

void require_possible(const CaptureInfo& info, const std::string& source) {
  require_possible_size(source, info.depth, max_depth_pixels);
  if (info.color) require_possible_size(source, *info.color, max_color_pixels);
  require_plausible(source, info.depth);
  if (!(info.depth_unit_m >= 1e-7 && info.depth_unit_m <= 1.0)) {
    throw Error(source, fmt::format("a depth unit of {} m is impossible", info.depth_unit_m),
                "correct the description");
  }
  const auto baseline_m = info.camera ? info.camera->baseline_m : std::nullopt;
  if (baseline_m && !(*baseline_m >= 1e-4 && *baseline_m <= 100.0)) {
    throw Error(source, fmt::format("a camera baseline of {} m is impossible", *baseline_m),
                "correct camera.baseline_m or leave it out");
  }
}

}  // namespace rva
