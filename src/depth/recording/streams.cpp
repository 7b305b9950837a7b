#include "depth/bag/bag_streams.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <chrono>
#include <cmath>
#include <map>
#include <string_view>
#include <utility>

#include "core/date_time.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"
#include "depth/bag/realsense_messages.hpp"

namespace rva {
namespace {

constexpr std::string_view image_data = "/image/data";

// The first stream of the first device that has images.
std::optional<BagStream> find_stream(const BagFile& bag, std::string_view kind) {
  constexpr std::string_view device = "/device_0/";
  for (const auto& [topic, content] : bag.index().topics) {
    if (!topic.starts_with(device) || !topic.ends_with(image_data) || content.messages.empty()) continue;
    const std::string name = topic.substr(0, topic.size() - image_data.size());
    const std::size_t sensor_end = name.rfind('/') + 1;
    if (name.substr(sensor_end).starts_with(kind)) return BagStream{name.substr(0, sensor_end), name};
  }
  return std::nullopt;
}

// "what" and what stands under it: option/Laser_Power/value gives Laser_Power.
template <typename Use>
void for_each_below(const BagFile& bag, const std::string& what, const Use& use) {
  const auto& topics = bag.index().topics;
  for (auto topic = topics.lower_bound(what); topic != topics.end() && topic->first.starts_with(what);
       ++topic) {
    if (!topic->second.messages.empty())
      use(topic->first.substr(what.size()), topic->second.messages.front());
  }
}

Intrinsics intrinsics(const BagFile& bag, const BagStream& stream) {
  const std::string topic = stream.name + "/info/camera_info";
  const auto& messages = bag.messages(topic);
  if (messages.empty()) throw Error(bag.place(), "lacks " + printable(topic), "record it again");
  return parse_camera_info(bag.read(messages.front()), bag.place());
}

// Each stream states its transform from a frame that it shares with the others of its group.
std::optional<Transform> color_from_depth(const BagFile& bag, const BagStream& color,
                                          const BagStream& depth) {
  const auto from_groups = [&](const BagStream& stream) {
    std::map<std::string, Transform> stream_from_group;
    for_each_below(bag, stream.name + "/tf/", [&](const std::string& group, const BagMessage& message) {
      stream_from_group[group] = parse_transform_message(bag.read(message), bag.place());
    });
    return stream_from_group;
  };
  const std::map<std::string, Transform> color_from_group = from_groups(color);
  for (const auto& [group, depth_from_group] : from_groups(depth)) {
    const auto same = color_from_group.find(group);
    if (same != color_from_group.end()) return same->second * depth_from_group.inverse();
  }
  return std::nullopt;
}

// As they were when the recording began.
std::map<std::string, double> settings_of(const BagFile& bag, const BagStream& stream) {
  std::map<std::string, double> settings;
  for_each_below(bag, stream.sensor + "option/", [&](std::string name, const BagMessage& message) {
    constexpr std::string_view value = "/value";
    if (!name.ends_with(value)) return;
    name.resize(name.size() - value.size());
    std::ranges::replace(name, '_', ' ');
    settings[name] = parse_float(bag.read(message), bag.place());
  });
  return settings;
}

using KeyValues = std::map<std::string, std::string>;

KeyValues key_values(const BagFile& bag, std::string_view topic) {
  KeyValues values;
  for (const BagMessage& message : bag.messages(topic))
    values.insert(parse_key_value(bag.read(message), bag.place()));
  return values;
}

std::string text_of(const KeyValues& values, const char* key) {
  const auto found = values.find(key);
  return found == values.end() ? std::string() : found->second;
}

std::optional<double> number_of(const KeyValues& values, const char* key) {
  const std::string text = text_of(values, key);
  double number = 0.0;
  const auto parsed = std::from_chars(text.data(), text.data() + text.size(), number);
  const bool sound = parsed.ec == std::errc{} && parsed.ptr == text.data() + text.size();
  return sound && std::isfinite(number) ? std::optional(number) : std::nullopt;
}

// Messages with the very time of an image are about it.
KeyValues image_metadata(const BagFile& bag, const BagStream& stream, const BagMessage& image) {
  const auto& messages = bag.messages(stream.name + "/image/metadata");
  KeyValues values;
  auto message = std::ranges::lower_bound(messages, image.time_ns, {}, &BagMessage::time_ns);
  for (; message != messages.end() && message->time_ns == image.time_ns; ++message)
    values.insert(parse_key_value(bag.read(*message), bag.place()));
  return values;
}

CameraInfo camera_of(const BagFile& bag, const BagStream& depth, const std::optional<BagStream>& color) {
  const KeyValues device = key_values(bag, "/device_0/info");
  CameraInfo camera{text_of(device, "Name"),
                    text_of(device, "Serial Number"),
                    {},
                    text_of(device, "Firmware Version"),
                    text_of(device, "Usb Type Descriptor"),
                    {}};
  const auto add_settings = [&](const BagStream& stream) {
    std::map<std::string, double> settings = settings_of(bag, stream);
    if (settings.empty()) return;
    const std::string name = text_of(key_values(bag, stream.sensor + "info"), "Name");
    camera.settings[name.empty() ? stream.sensor : name] = std::move(settings);
  };
  add_settings(depth);
  if (color && color->sensor != depth.sensor) add_settings(*color);
  const std::map<std::string, double> settings = settings_of(bag, depth);
  if (const auto baseline_mm = settings.find("Stereo Baseline"); baseline_mm != settings.end())
    camera.baseline_m = 0.001 * baseline_mm->second;
  return camera;
}

// The unit that goes with the first image, or, in older files, what the camera was set to.
double depth_unit_m(const BagFile& bag, const BagStream& depth, CaptureInfo& info) {
  const std::vector<std::byte> message = bag.read(images(bag, depth).front());
  if (const auto unit_m = parse_image_message(message, bag.place()).unit_m) return shortest_decimal(*unit_m);
  const std::map<std::string, double> settings = settings_of(bag, depth);
  if (const auto unit_m = settings.find("Depth Units"); unit_m != settings.end()) return unit_m->second;
  info.notes.emplace_back("the file does not state its depth unit; 1 mm, as cameras are made, is assumed");
  return 0.001;
}

// When the first image came, by the clock of the computer.
std::string captured_at(const BagFile& bag, const BagStream& depth) {
  const KeyValues values = image_metadata(bag, depth, images(bag, depth).front());
  const auto since_1970_ms = number_of(values, "Time Of Arrival");
  constexpr double year_2255_ms = 9e12;  // the clock counts nanoseconds in 64 bits
  if (!since_1970_ms || *since_1970_ms < 0.0 || *since_1970_ms > year_2255_ms) return {};
  return iso_8601(std::chrono::system_clock::time_point(
      std::chrono::milliseconds(static_cast<std::int64_t>(*since_1970_ms))));
}

void note_what_is_missing(const BagFile& bag, CaptureInfo& info) {
  if (!bag.index().finished)
    info.notes.emplace_back(
        "the recorder was stopped before it ended the file, or the file is cut short; what is whole was "
        "read");
  if (const std::size_t chunks = bag.index().damaged_chunks; chunks > 0)
    info.notes.push_back(fmt::format("{} damaged part(s) of the file were left out", chunks));
  const auto other = bag.index().topics.lower_bound("/device_1/");
  if (other != bag.index().topics.end() && other->first.starts_with("/device_1/"))
    info.notes.emplace_back("the file holds other cameras, too, which are left out");
}

Error without_depth(const BagFile& bag) {
  std::string seen;
  int more = 0;
  for (const auto& [name, topic] : bag.index().topics) {
    if (topic.messages.empty() || !topic.type.starts_with("sensor_msgs/")) continue;
    if (more++ < 3)
      seen += fmt::format("{}{} ({})", seen.empty() ? "" : ", ", printable(name), printable(topic.type));
  }
  if (seen.empty()) seen = "no image at all";
  return {bag.place(),
          fmt::format("no depth of realsense-viewer in it, but {}{}", seen, more > 3 ? ", ..." : ""),
          "record with the depth stream on"};
}

}  // namespace

const std::vector<BagMessage>& images(const BagFile& bag, const BagStream& stream) {
  return bag.messages(stream.name + std::string(image_data));
}

BagStreams find_streams(const BagFile& bag) {
  const auto depth = find_stream(bag, "Depth_");
  if (!depth) throw without_depth(bag);
  // Infrared 1 is the left imager, whose view is the depth's.
  return {*depth, find_stream(bag, "Color_"), find_stream(bag, "Infrared_1")};
}

CaptureInfo describe(const BagFile& bag, const BagStreams& streams) {
  CaptureInfo info;
  info.format = "bag";
  info.depth = intrinsics(bag, streams.depth);
  info.depth_unit_m = depth_unit_m(bag, streams.depth, info);
  if (streams.color) {
    info.color = intrinsics(bag, *streams.color);
    info.color_from_depth = color_from_depth(bag, *streams.color, streams.depth);
  }
  info.camera = camera_of(bag, streams.depth, streams.color);
  info.captured_at = captured_at(bag, streams.depth);
  note_what_is_missing(bag, info);
  return info;
}

FrameMetadata metadata_of(const BagFile& bag, const BagStream& stream, const BagMessage& image) {
  const std::vector<std::byte> message = bag.read(image);
  const ImageMessage header = parse_image_message(message, bag.place());
  const KeyValues values = image_metadata(bag, stream, image);
  FrameMetadata metadata;
  metadata.counter = header.sequence;
  metadata.time_s = header.time_s;
  metadata.exposure_us = number_of(values, "Actual Exposure");
  metadata.gain = number_of(values, "Gain Level");
  metadata.laser_power_mw = number_of(values, "Frame Laser Power");
  return metadata;
}

}  // namespace rva
