#include "capture/mcap/mcap_capture_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>
#include <utility>

#include "capture/folder/capture_writer.hpp"
#include "capture/formats.hpp"
#include "capture/recording/described_capture.hpp"
#include "core/date_time.hpp"
#include "core/error.hpp"
#include "core/json_object.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

constexpr double ns_per_s = 1e9;
constexpr double usual_frame_s = 1.0 / 30.0;  // between frames whose times are not known
constexpr std::string_view depth_frame = "camera_depth_optical_frame";
constexpr std::string_view color_frame = "camera_color_optical_frame";
constexpr MessageType json_type{"rva.Json", R"({"type": "object"})"};

bool is_json(const MessageType& type) { return type.name == json_type.name; }

template <typename Pixel, typename Meaning>
RawImage raw(const Image<Pixel, Meaning>& image, std::string_view encoding) {
  return {image.width(), image.height(), encoding, std::as_bytes(image.pixels())};
}

Image<float> metres(const DepthImage& depth, double unit_m) {
  Image<float> result(depth.width(), depth.height());
  std::ranges::transform(depth.pixels(), result.pixels().begin(),
                         [&](std::uint16_t units) { return static_cast<float>(units * unit_m); });
  return result;
}

std::span<const std::byte> bytes_of(std::string_view text) { return std::as_bytes(std::span(text)); }

template <typename Pixel, typename Meaning>
void require_size(const Image<Pixel, Meaning>& image, const Intrinsics& stated) {
  if (image.width() == stated.width && image.height() == stated.height) return;
  throw Error("capture",
              fmt::format("an image has {}x{} pixels, but the capture states {}x{}", image.width(),
                          image.height(), stated.width, stated.height),
              "record the capture again");
}

}  // namespace

McapCaptureWriter::McapCaptureWriter(const std::filesystem::path& file, const CaptureInfo& info,
                                     std::string extra_json_object)
    : info_(info),
      extra_json_object_(std::move(extra_json_object)),
      start_ns_(ns_since_1970(info.captured_at).value_or(0)),
      file_(file, "ros2") {
  info_.infrared.reset();
  info_.lamp.reset();
  const std::string description = json_file_text(json_of(info_, extra_json_object_));
  require_possible(parse_capture_json(description, printable(file)), printable(file));
  write_description();
  write_transforms();
}

void McapCaptureWriter::write_description() {
  const std::string text = json_file_text(json_of(info_, extra_json_object_));
  file_.write(channel(recorded_topic::description, json_type), start_ns_, bytes_of(text));
}

void McapCaptureWriter::write_transforms() {
  const auto write = [&](std::string_view frame, std::string_view child, const Transform& frame_from_child) {
    file_.write(channel(recorded_topic::transforms, transforms_type), start_ns_,
                transform_message({start_ns_, frame}, child, frame_from_child));
  };
  if (info_.color_from_depth) write(depth_frame, color_frame, info_.color_from_depth->inverse());
  if (info_.pose && info_.pose->world_from_camera) write("map", depth_frame, *info_.pose->world_from_camera);
}

McapWriter::Id McapCaptureWriter::channel(std::string_view topic, const MessageType& type) {
  if (const auto known = channels_.find(topic); known != channels_.end()) return known->second;
  auto schema = schemas_.find(type.name);
  if (schema == schemas_.end())
    schema = schemas_
                 .emplace(type.name, file_.add_schema(type.name, is_json(type) ? "jsonschema" : "ros2msg",
                                                      type.definition))
                 .first;
  const McapWriter::Id id = file_.add_channel(schema->second, topic, is_json(type) ? "json" : "cdr");
  channels_.emplace(topic, id);
  return id;
}

// Frames of different numbers have different times, so that images of one frame are found by its time.
std::uint64_t McapCaptureWriter::time_of(std::size_t number) {
  const auto known = times_ns_.find(number);
  if (known != times_ns_.end()) return known->second;
  const double usual_ns = ns_per_s * usual_frame_s * static_cast<double>(number);
  return times_ns_[number] = start_ns_ + static_cast<std::uint64_t>(usual_ns);
}

void McapCaptureWriter::write_metadata(std::size_t number, const FrameMetadata& metadata) {
  const std::string line = frame_line(number, metadata);
  const std::lock_guard lock(mutex_);
  if (metadata.time_s) {
    if (!first_time_s_) first_time_s_ = metadata.time_s;
    const double since_ns = std::max(0.0, ns_per_s * (*metadata.time_s - *first_time_s_));
    std::uint64_t time_ns = start_ns_ + static_cast<std::uint64_t>(since_ns);
    const auto before = times_ns_.lower_bound(number);
    if (before != times_ns_.begin()) time_ns = std::max(time_ns, std::prev(before)->second + 1);
    times_ns_[number] = time_ns;
  }
  file_.write(channel(recorded_topic::frame, json_type), time_of(number), bytes_of(line));
}

void McapCaptureWriter::write_image(std::size_t number, std::string_view topic, std::string_view frame,
                                    const RawImage& image, const Intrinsics* camera) {
  std::vector<std::byte> message;
  std::uint64_t time_ns = 0;
  {
    const std::lock_guard lock(mutex_);
    time_ns = time_of(number);
  }
  message = image_message({time_ns, frame}, image);
  const std::lock_guard lock(mutex_);
  if (camera != nullptr)
    file_.write(channel(camera_info_topic(topic), camera_info_type), time_ns,
                camera_info_message({time_ns, frame}, *camera));
  file_.write(channel(topic, image_type), time_ns, message);
}

void McapCaptureWriter::write_depth(std::size_t number, const DepthImage& image) {
  require_size(image, info_.depth);
  constexpr double mm = 0.001;
  if (info_.depth_unit_m == mm) {
    write_image(number, recorded_topic::depth, depth_frame, raw(image, "16UC1"), &info_.depth);
  } else {
    const Image<float> depth_m = metres(image, info_.depth_unit_m);
    write_image(number, recorded_topic::depth, depth_frame, raw(depth_m, "32FC1"), &info_.depth);
  }
}

void McapCaptureWriter::write_color(std::size_t number, const ColorImage& image) {
  if (info_.color) require_size(image, *info_.color);
  write_image(number, recorded_topic::color, color_frame, raw(image, "rgb8"),
              info_.color ? &*info_.color : nullptr);
}

void McapCaptureWriter::write_infrared(Imager imager, Light light, const FineGrayImage& mean,
                                       const InfraredBurst& burst) {
  require_size(mean, info_.depth);
  (light == Light::lamp ? info_.lamp : info_.infrared) = burst;
  write_image(0, infrared_topic(imager, light), depth_frame, raw(mean, "mono16"),
              light == Light::lamp ? nullptr : &info_.depth);
}

void McapCaptureWriter::write_infrared_of(std::size_t number, Imager imager, const FineGrayImage& image) {
  require_size(image, info_.depth);
  write_image(number, infrared_topic(imager, Light::projector), depth_frame, raw(image, "mono16"),
              &info_.depth);
}

void McapCaptureWriter::finish() {
  if (info_.infrared || info_.lamp) write_description();
  file_.finish();
}

}  // namespace rva
