#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <nlohmann/json.hpp>
#include <system_error>

#include "core/error.hpp"
#include "core/file.hpp"
#include "core/json_object.hpp"
#include "core/path_text.hpp"
#include "depth/formats.hpp"
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
    const auto model = distortion_from_name(*name);
    if (!model) {
      throw Error(object.name_of("distortion_model"),
                  fmt::format("the model '{}' is not known", printable(*name)),
                  "use none, brown_conrady or inverse_brown_conrady");
    }
    camera.distortion = *model;
  }
  if (object.has("distortion"))
    std::ranges::copy(object.numbers("distortion", 5), camera.coefficients.begin());
  try {
    camera.check();
  } catch (const Error& error) {
    throw Error(object.name_of(error.place()), error.problem(), "correct the file");
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
  if (object.has("world_from_camera")) pose.world_from_camera = parse_transform(object, "world_from_camera");
  return pose;
}

// Refused before memory is taken for a single image of that size.
void require_possible_size(const std::string& place, const Intrinsics& camera) {
  if (camera.width <= max_image_pixels / camera.height) return;
  throw Error(place,
              fmt::format("states images of {}x{} pixels, larger than any camera of ours gives", camera.width,
                          camera.height),
              "correct the description");
}

void require_format(const JsonObject& document, const std::string& place) {
  if (document.string("format") != "rva-capture") {
    throw Error(place, "the format is not 'rva-capture'", "give the description of a capture");
  }
  if (const int version = document.integer("version"); version != 1) {
    throw Error(place, fmt::format("version {} of the format is not known", version), "use a newer rva");
  }
}

}  // namespace

CaptureInfo parse_capture_json(const std::string& text, const std::string& place) {
  const nlohmann::json json = parse_json(text, place);
  const JsonObject document(json, place);
  require_format(document, place);
  CaptureInfo info;
  info.format = "rva-capture";
  info.source_json = text;
  const JsonObject depth = document.object("depth");
  info.depth = parse_intrinsics(depth);
  info.depth_unit_m = depth.number("unit_m");
  if (const auto color = document.optional_object("color")) info.color = parse_intrinsics(*color);
  if (document.has("color_from_depth")) info.color_from_depth = parse_transform(document, "color_from_depth");
  if (const auto pose = document.optional_object("pose")) info.pose = parse_pose(*pose);
  if (const auto camera = document.optional_object("camera")) {
    info.camera =
        CameraInfo{camera->optional_string("model").value_or(""),
                   camera->optional_string("serial").value_or(""), camera->optional_number("baseline_m")};
  }
  info.captured_at = document.optional_string("captured_at").value_or("");
  return info;
}

std::vector<fs::path> image_files(const fs::path& folder, const std::vector<std::string_view>& endings) {
  std::vector<fs::path> files;
  std::error_code failure;
  if (!fs::exists(folder, failure) && !failure) return files;
  for (fs::directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    const fs::path& path = entry->path();
    std::string ending = path.extension().native();
    std::ranges::transform(ending, ending.begin(), [](unsigned char letter) { return std::tolower(letter); });
    const bool hidden = path.filename().native().starts_with('.');  // other systems leave such beside images
    if (!hidden && std::ranges::find(endings, ending) != endings.end()) files.push_back(path);
  }
  if (failure) {
    throw Error(printable(folder), fmt::format("cannot be read ({})", failure.message()),
                "check its permissions");
  }
  std::ranges::sort(files);
  return files;
}

std::unique_ptr<Capture> open_capture_folder(const fs::path& folder) {
  const fs::path description = folder / "capture.json";
  return std::make_unique<FolderCapture>(
      folder, parse_capture_json(read_text_file(description), printable(description)),
      image_files(folder / "depth", {".png"}), image_files(folder / "color", {".png", ".jpg", ".jpeg"}));
}

void require_possible(const CaptureInfo& info, const std::string& place) {
  require_possible_size(place, info.depth);
  if (info.color) require_possible_size(place, *info.color);
  if (!(info.depth_unit_m >= 1e-7 && info.depth_unit_m <= 1.0)) {
    throw Error(place, fmt::format("a depth unit of {} m makes no sense", info.depth_unit_m),
                "correct the description");
  }
  const auto baseline_m = info.camera ? info.camera->baseline_m : std::nullopt;
  if (baseline_m && !(*baseline_m >= 1e-4 && *baseline_m <= 100.0)) {
    throw Error(place, fmt::format("a camera baseline of {} m makes no sense", *baseline_m),
                "correct camera.baseline_m or leave it out");
  }
}

FolderCapture::FolderCapture(const fs::path& place, CaptureInfo info, std::vector<fs::path> depth_files,
                             std::vector<fs::path> color_files)
    : Capture(std::move(info)), depth_files_(std::move(depth_files)), color_files_(std::move(color_files)) {
  require_possible(this->info(), printable(place));
  if (depth_files_.empty()) throw Error(printable(place), "holds no depth frame", "record the capture again");
}

DepthImage FolderCapture::depth(std::size_t i) const {
  DepthImage image = read_depth(depth_files_.at(i));
  const Intrinsics& expected = info().depth;
  if (image.width() != expected.width || image.height() != expected.height) {
    throw Error(printable(depth_files_[i]),
                fmt::format("{}x{} pixels where the capture states {}x{}", image.width(), image.height(),
                            expected.width, expected.height),
                "record the capture again");
  }
  return image;
}

ColorImage FolderCapture::color(std::size_t i) const {
  ColorImage image = read_color(color_files_.at(i));
  const auto& expected = info().color;
  if (expected && (image.width() != expected->width || image.height() != expected->height)) {
    throw Error(printable(color_files_[i]),
                fmt::format("{}x{} pixels where the capture states {}x{}", image.width(), image.height(),
                            expected->width, expected->height),
                "record the capture again");
  }
  return image;
}

}  // namespace rva
