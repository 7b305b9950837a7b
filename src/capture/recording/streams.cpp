#include "capture/recording/streams.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <map>
#include <string_view>
#include <utility>

#include "capture/recording/ros_streams.hpp"
#include "core/date_time.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

constexpr std::string_view image_data = "/image/data";

// The first stream of this kind on the first device that has images.
std::optional<RecordedStream> find_stream(const Recording& recording, std::string_view kind) {
  constexpr std::string_view device = "/device_0/";
  for (const auto& [topic, content] : recording.topics()) {
    if (!topic.starts_with(device) || !topic.ends_with(image_data) || content.messages.empty()) continue;
    const std::string name = topic.substr(0, topic.size() - image_data.size());
    const std::size_t sensor_end = name.rfind('/') + 1;
    if (name.substr(sensor_end).starts_with(kind)) return RecordedStream{name.substr(0, sensor_end), name};
  }
  return std::nullopt;
}

// Each stream states its transform from the frame of a group. Streams of the same group can be related.
std::optional<Transform> color_from_depth(const Recording& recording, const RecordedStream& color,
                                          const RecordedStream& depth) {
  const std::map<std::string, Transform> color_from_group = recording.stream_from_groups(color);
  for (const auto& [group, depth_from_group] : recording.stream_from_groups(depth)) {
    const auto same = color_from_group.find(group);
    if (same != color_from_group.end()) return same->second * depth_from_group.inverse();
  }
  return std::nullopt;
}

std::string frame_of(const Recording& recording, const RecordedStream& stream) {
  return std::string(
      recording.image(stream, recording.messages(stream.images()).front(), recording.source()).frame);
}

// Depth that the ROS node has aligned to colour is published under a topic with this name. Otherwise, the
// static transforms relate the frames of the images. Damaged ones do not prevent the comparison of depth.
std::optional<Transform> color_from_depth_of_ros(const Recording& recording, const RecordedStream& color,
                                                 const RecordedStream& depth, CaptureInfo& info) {
  if (depth.ros_images.find("aligned_depth_to_color") != std::string::npos) return Transform::Identity();
  try {
    const std::vector<StaticTransform> transforms = recording.static_transforms();
    if (transforms.empty()) return std::nullopt;  // not even equal names of frames mean anything then
    return transform_between(transforms, frame_of(recording, color), frame_of(recording, depth));
  } catch (const Error& error) {
    info.notes.push_back(
        fmt::format("the transform between its imagers cannot be read: {}", error.problem()));
    return std::nullopt;
  }
}

std::string text_of(const KeyValues& values, const char* key) {
  const auto found = values.find(key);
  return found == values.end() ? std::string() : found->second;
}

std::optional<double> number_of(const KeyValues& values, const char* key) {
  return decimal_number(text_of(values, key));
}

CameraInfo camera_of(const Recording& recording, const RecordedStream& depth,
                     const std::optional<RecordedStream>& color) {
  const KeyValues device = recording.info("/device_0/info");
  CameraInfo camera{.model = text_of(device, "Name"),
                    .serial = text_of(device, "Serial Number"),
                    .firmware = text_of(device, "Firmware Version"),
                    .usb = text_of(device, "Usb Type Descriptor")};
  const auto add_settings = [&](const RecordedStream& stream) {
    std::map<std::string, double> settings = recording.settings(stream.sensor);
    if (settings.empty()) return;
    const std::string name = text_of(recording.info(stream.sensor + "info"), "Name");
    camera.settings[name.empty() ? stream.sensor : name] = std::move(settings);
  };
  add_settings(depth);
  if (color && color->sensor != depth.sensor) add_settings(*color);
  const std::map<std::string, double> settings = recording.settings(depth.sensor);
  if (const auto baseline_mm = settings.find("Stereo Baseline"); baseline_mm != settings.end())
    camera.baseline_m = 0.001 * baseline_mm->second;
  return camera;
}

// ROS depth is in millimetres, or in metres as floating point (REP 118). The latter is converted to tenths of
// a millimetre where nearly all of it fits into 16 bits, else to millimetres.
double unit_of_ros(const ImageMessage& first, const std::string& source) {
  constexpr double mm = 0.001;
  constexpr double tenth_of_a_mm = 0.0001;
  constexpr double most_lost = 0.001;
  if (first.encoding != "32FC1") return mm;
  const auto measured = [&](double unit_m) {
    const DepthImage depth = depth_of(first, unit_m, source);
    return static_cast<double>(
        std::ranges::count_if(depth.pixels(), [](auto units) { return units != no_depth; }));
  };
  return measured(tenth_of_a_mm) >= (1.0 - most_lost) * measured(mm) ? tenth_of_a_mm : mm;
}

// The unit stated with the first image, or, in older files, the camera's setting.
double depth_unit_m(const Recording& recording, const RecordedStream& depth, CaptureInfo& info) {
  const RecordedMessage& first = recording.messages(depth.images()).front();
  const ImageMessage image = recording.image(depth, first, recording.source());
  if (image.unit_m) return *image.unit_m;
  if (depth.is_of_ros()) return unit_of_ros(image, recording.source());
  const std::map<std::string, double> settings = recording.settings(depth.sensor);
  if (const auto unit_m = settings.find("Depth Units"); unit_m != settings.end()) return unit_m->second;
  info.unit_is_assumed = true;
  return 0.001;
}

Intrinsics of_first_image(const Recording& recording, const RecordedStream& depth, Intrinsics camera) {
  const ImageMessage first =
      recording.image(depth, recording.messages(depth.images()).front(), recording.source());
  camera.width = first.width;
  camera.height = first.height;
  camera.check();
  return camera;
}

// The arrival time of the first image, by the clock of the computer.
std::string captured_at(const Recording& recording, const RecordedStream& depth) {
  const KeyValues values = recording.metadata(depth, recording.messages(depth.images()).front());
  const auto since_1970_ms = number_of(values, "Time Of Arrival");
  constexpr double year_2255_ms = 9e12;  // the clock counts nanoseconds in 64 bits
  if (!since_1970_ms || *since_1970_ms < 0.0 || *since_1970_ms > year_2255_ms) return {};
  return iso_8601(std::chrono::system_clock::time_point(
      std::chrono::milliseconds(static_cast<std::int64_t>(*since_1970_ms))));
}

void note_what_is_missing(const Recording& recording, CaptureInfo& info) {
  const std::vector<std::string> notes = recording.notes();
  info.notes.insert(info.notes.end(), notes.begin(), notes.end());
  const auto other = recording.topics().lower_bound("/device_1/");
  if (other != recording.topics().end() && other->first.starts_with("/device_1/"))
    info.notes.emplace_back("the file has recordings of further cameras, which are left out");
}

Error without_depth(const Recording& recording) {
  std::string seen;
  int more = 0;
  for (const auto& [name, topic] : recording.topics()) {
    if (topic.messages.empty() || !topic.type.starts_with("sensor_msgs/")) continue;
    if (more++ < 3)
      seen += fmt::format("{}{} ({})", seen.empty() ? "" : ", ", printable(name), printable(topic.type));
  }
  if (seen.empty() && !recording.notes().empty())
    return {recording.source(), "the file is cut short or was never finished, and no image in it is complete",
            "copy it again, or record it again"};
  const std::string instead =
      seen.empty() ? ", and no other image" : fmt::format(", but {}{}", seen, more > 3 ? ", ..." : "");
  return {recording.source(), "contains no depth" + instead, "record with the depth stream on"};
}

}  // namespace

RecordedStreams find_streams(const Recording& recording, const std::optional<std::string>& depth_topic) {
  const auto depth = depth_topic ? std::nullopt : find_stream(recording, "Depth_");
  if (!depth) {
    if (auto of_ros = find_ros_streams(recording, depth_topic)) return std::move(*of_ros);
    throw without_depth(recording);
  }
  RecordedStreams streams{*depth, find_stream(recording, "Color_"), {}, {}};
  // Infrared 1 is the left imager, which has the view of the depth images.
  for (const auto& [imager, name] : {std::pair(Imager::left, "Infrared_1"), {Imager::right, "Infrared_2"}}) {
    if (const auto stream = find_stream(recording, name)) streams.infrared.emplace(imager, *stream);
  }
  return streams;
}

CaptureInfo describe(const Recording& recording, const RecordedStreams& streams,
                     const std::optional<Intrinsics>& intrinsics) {
  CaptureInfo info;
  info.format = recording.format();
  info.depth = intrinsics ? of_first_image(recording, streams.depth, *intrinsics)
                          : recording.intrinsics(streams.depth);
  info.depth_unit_m = depth_unit_m(recording, streams.depth, info);
  if (streams.color) {
    info.color = recording.intrinsics(*streams.color);
    info.color_from_depth = streams.depth.is_of_ros()
                                ? color_from_depth_of_ros(recording, *streams.color, streams.depth, info)
                                : color_from_depth(recording, *streams.color, streams.depth);
  }
  if (!streams.depth.is_of_ros()) info.camera = camera_of(recording, streams.depth, streams.color);
  info.captured_at = captured_at(recording, streams.depth);
  note_what_is_missing(recording, info);
  return info;
}

FrameMetadata metadata_of(const Recording& recording, const RecordedStream& stream,
                          const RecordedMessage& image) {
  const ImageMessage header = recording.image(stream, image, recording.source());
  const KeyValues values = recording.metadata(stream, image);
  FrameMetadata metadata;
  metadata.counter = header.counter;
  metadata.time_s = header.time_s;
  metadata.exposure_us = number_of(values, "Actual Exposure");
  metadata.gain = number_of(values, "Gain Level");
  metadata.laser_power_mw = number_of(values, "Frame Laser Power");
  return metadata;
}

}  // namespace rva
