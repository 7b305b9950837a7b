#include "capture/recording/ros_streams.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <tuple>
#include <vector>

#include "capture/recording/compressed_image.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

bool is_image(std::string_view type) {
  return type == "sensor_msgs/Image" || type == "sensor_msgs/msg/Image" || is_compressed_image(type);
}

bool is_depth(std::string_view encoding) {
  return encoding == "16UC1" || encoding == "32FC1" || encoding == "mono16";
}

bool is_color(std::string_view encoding) {
  return encoding == "rgb8" || encoding == "bgr8" || encoding == "rgba8" || encoding == "bgra8";
}

bool is_gray(std::string_view encoding) { return encoding == "mono8" || encoding == "8UC1"; }

bool names(std::string_view topic, std::string_view word) {
  return topic.find(word) != std::string_view::npos;
}

// "/camera/depth/" for "/camera/depth/image_rect_raw".
std::string_view namespace_of(std::string_view topic) { return topic.substr(0, topic.rfind('/') + 1); }

RecordedStream stream_of(const std::string& topic) {
  const std::string beginning(namespace_of(without_transport(topic)));
  return {.sensor = beginning,
          .name = beginning,
          .ros_images = topic,
          .ros_camera_info = beginning + "camera_info"};
}

/// A topic of images, with the encoding of the first one.
struct ImageTopic {
  std::string name;
  std::string encoding;
  std::size_t messages = 0;
};

// Empty for a compressed colour image that cannot be read, since colour does not stop the comparison of
// depth.
std::optional<std::string> encoding_of(const Recording& recording, const std::string& topic,
                                       const RecordedMessage& message) {
  try {
    return std::string(
        recording.image(stream_of(topic), message, recording.source() + ", " + printable(topic)).encoding);
  } catch (const Error&) {
    if (recording.is_compressed(topic) && !names(topic, "epth")) return std::nullopt;
    throw;
  }
}

std::vector<ImageTopic> image_topics(const Recording& recording) {
  std::vector<ImageTopic> topics;
  for (const auto& [name, topic] : recording.topics()) {
    if (!is_image(topic.type) || topic.messages.empty()) continue;
    if (auto encoding = encoding_of(recording, name, topic.messages.front()))
      topics.push_back({name, std::move(*encoding), topic.messages.size()});
  }
  return topics;
}

// Prefers topics named depth to other images of 16 bits, then depth in the camera's own view to depth aligned
// to another imager, then the topic with more messages.
std::optional<std::string> depth_among(const std::vector<ImageTopic>& topics) {
  const ImageTopic* best = nullptr;
  const auto rank = [](const ImageTopic& topic) {
    return std::tuple(names(topic.name, "depth"), !names(topic.name, "aligned"), topic.messages);
  };
  for (const ImageTopic& topic : topics) {
    if (!is_depth(topic.encoding) || names(topic.name, "infra")) continue;
    if (best == nullptr || rank(topic) > rank(*best)) best = &topic;
  }
  return best == nullptr ? std::nullopt : std::optional(best->name);
}

std::string stated_depth(const Recording& recording, const std::vector<ImageTopic>& topics,
                         const std::string& wanted) {
  const auto found = std::ranges::find(topics, wanted, &ImageTopic::name);
  if (found != topics.end() && is_depth(found->encoding)) return wanted;
  throw Error(recording.source(), fmt::format("the topic {} has no depth image", printable(wanted)),
              "give one of 16UC1 or 32FC1 images");
}

bool has_intrinsics(const Recording& recording, const std::string& topic) {
  return !recording.messages(stream_of(topic).ros_camera_info).empty();
}

// The length of the common beginning of two names, which is longest for topics of the same camera.
std::size_t shared(std::string_view a, std::string_view b) {
  return static_cast<std::size_t>(std::ranges::mismatch(a, b).in1 - a.begin());
}

std::optional<RecordedStream> beside(const Recording& recording, const std::vector<ImageTopic>& topics,
                                     std::string_view depth, auto&& wanted) {
  const ImageTopic* best = nullptr;
  for (const ImageTopic& topic : topics) {
    if (!wanted(topic) || !has_intrinsics(recording, topic.name)) continue;
    if (best == nullptr || shared(topic.name, depth) > shared(best->name, depth)) best = &topic;
  }
  return best == nullptr ? std::nullopt : std::optional(stream_of(best->name));
}

}  // namespace

std::optional<RecordedStreams> find_ros_streams(const Recording& recording,
                                                const std::optional<std::string>& depth_topic) {
  const std::vector<ImageTopic> topics = image_topics(recording);
  const std::optional<std::string> depth =
      depth_topic ? stated_depth(recording, topics, *depth_topic) : depth_among(topics);
  if (!depth) return std::nullopt;
  RecordedStreams streams{stream_of(*depth), {}, {}, {}};
  streams.color =
      beside(recording, topics, *depth, [](const ImageTopic& topic) { return is_color(topic.encoding); });
  const auto infrared_of = [&](std::string_view word) {
    return beside(recording, topics, *depth, [word](const ImageTopic& topic) {
      return is_gray(topic.encoding) && names(topic.name, word);
    });
  };
  for (const auto& [imager, word] : {std::pair(Imager::left, "infra1"), {Imager::right, "infra2"}}) {
    if (auto stream = infrared_of(word)) streams.infrared.emplace(imager, std::move(*stream));
  }
  return streams;
}

}  // namespace rva
