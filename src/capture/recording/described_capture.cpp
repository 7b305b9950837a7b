#include "capture/recording/described_capture.hpp"

#include "capture/formats.hpp"
#include "core/error.hpp"

namespace rva {
namespace {

RecordedStream stream_of(std::string_view images) {
  return {.sensor = {},
          .name = {},
          .ros_images = std::string(images),
          .ros_camera_info = camera_info_topic(images)};
}

bool has_messages(const Recording& recording, std::string_view topic) {
  return !recording.messages(topic).empty();
}

}  // namespace

std::string_view infrared_topic(Imager imager, Light light) {
  if (light == Light::lamp)
    return imager == Imager::left ? "/camera/infra1/lamp/image_raw" : "/camera/infra2/lamp/image_raw";
  return imager == Imager::left ? "/camera/infra1/image_rect_raw" : "/camera/infra2/image_rect_raw";
}

std::string camera_info_topic(std::string_view images) {
  return std::string(images.substr(0, images.rfind('/') + 1)) + "camera_info";
}

bool is_described(const Recording& recording) {
  return has_messages(recording, recorded_topic::description) &&
         !recording.text(recording.messages(recorded_topic::description).back(), recorded_topic::description)
              .empty();
}

CaptureInfo described_info(const Recording& recording, const std::optional<Intrinsics>& intrinsics) {
  const RecordedMessage& last = recording.messages(recorded_topic::description).back();
  CaptureInfo info =
      parse_capture_json(recording.text(last, recorded_topic::description), recording.source());
  info.format = recording.format();
  if (intrinsics) {
    const Intrinsics stated = info.depth;
    info.depth = *intrinsics;
    info.depth.width = stated.width;
    info.depth.height = stated.height;
  }
  const std::vector<std::string> notes = recording.notes();
  info.notes.insert(info.notes.end(), notes.begin(), notes.end());
  return info;
}

RecordedStreams described_streams(const Recording& recording) {
  if (!has_messages(recording, recorded_topic::depth))
    throw Error(recording.source(), "no depth image in it is complete", "copy it again, or record it again");
  RecordedStreams streams{.depth = stream_of(recorded_topic::depth), .color = {}, .infrared = {}, .lamp = {}};
  if (has_messages(recording, recorded_topic::color)) streams.color = stream_of(recorded_topic::color);
  for (const Imager imager : both_imagers) {
    if (const auto topic = infrared_topic(imager, Light::projector); has_messages(recording, topic))
      streams.infrared.emplace(imager, stream_of(topic));
    if (const auto topic = infrared_topic(imager, Light::lamp); has_messages(recording, topic))
      streams.lamp.emplace(imager, stream_of(topic));
  }
  return streams;
}

}  // namespace rva
