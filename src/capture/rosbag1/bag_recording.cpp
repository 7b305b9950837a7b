#include "capture/rosbag1/bag_recording.hpp"

#include <fmt/format.h>

#include "capture/rosbag1/bag_file.hpp"
#include "capture/rosbag1/bag_messages.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

class BagRecording : public Recording {
 public:
  explicit BagRecording(const std::filesystem::path& file) : bag_(file) {}

  [[nodiscard]] std::string_view format() const override { return "bag"; }
  [[nodiscard]] const std::string& source() const override { return bag_.source(); }
  [[nodiscard]] const RecordedTopics& topics() const override { return bag_.index().topics; }

  [[nodiscard]] std::vector<std::string> notes() const override {
    std::vector<std::string> notes;
    if (!bag_.index().finished)
      notes.emplace_back(
          "the recorder was stopped before it finished the file, or the file is cut short; what is complete "
          "was read");
    if (const std::size_t chunks = bag_.index().damaged_chunks; chunks > 0)
      notes.push_back(fmt::format("{} damaged part(s) of the file were left out", chunks));
    return notes;
  }

  [[nodiscard]] ImageMessage image(const RecordedStream& stream, const RecordedMessage& message,
                                   std::string_view source) const override {
    if (is_compressed(stream.images())) return parse_compressed_message(bag_.read(message), source);
    return parse_image_message(bag_.read(message), source);
  }

  [[nodiscard]] KeyValues metadata(const RecordedStream& stream,
                                   const RecordedMessage& image) const override {
    return key_values(messages_at(stream.metadata(), image.time_ns));
  }

  [[nodiscard]] KeyValues info(const std::string& topic) const override {
    return key_values(messages(topic));
  }

  [[nodiscard]] std::map<std::string, double> settings(const std::string& sensor) const override {
    std::map<std::string, double> settings;
    for_each_below(sensor + "option/", [&](std::string_view name, const RecordedMessage& message) {
      if (const auto setting = setting_of(name))
        settings[*setting] = parse_float(bag_.read(message), source());
    });
    return settings;
  }

  [[nodiscard]] Intrinsics intrinsics(const RecordedStream& stream) const override {
    const std::string topic = stream.is_of_ros() ? stream.ros_camera_info : stream.name + "/info/camera_info";
    const auto& stated = messages(topic);
    if (stated.empty()) throw lacks_intrinsics(source(), topic);
    return parse_camera_info(bag_.read(stated.front()), source());
  }

  [[nodiscard]] std::map<std::string, Transform> stream_from_groups(
      const RecordedStream& stream) const override {
    std::map<std::string, Transform> stream_from_group;
    for_each_below(stream.name + "/tf/", [&](std::string_view group, const RecordedMessage& message) {
      stream_from_group.emplace(group, parse_transform_message(bag_.read(message), source()));
    });
    return stream_from_group;
  }

  [[nodiscard]] std::vector<StaticTransform> static_transforms() const override {
    return transforms_of(messages("/tf_static"), [&](const RecordedMessage& message) {
      return parse_transforms(bag_.read(message), source());
    });
  }

 private:
  [[nodiscard]] KeyValues key_values(const std::vector<RecordedMessage>& messages) const {
    KeyValues values;
    for (const RecordedMessage& message : messages)
      values.insert(parse_key_value(bag_.read(message), source()));
    return values;
  }

  BagFile bag_;
};

}  // namespace

std::unique_ptr<Recording> open_bag_recording(const std::filesystem::path& file) {
  return std::make_unique<BagRecording>(file);
}

}  // namespace rva
