#include "capture/rosbag2/db3_recording.hpp"

#include "capture/rosbag2/db3_messages.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

class Db3Recording : public Recording {
 public:
  explicit Db3Recording(const std::filesystem::path& file) : file_(file) {}

  [[nodiscard]] std::string_view format() const override { return "db3"; }
  [[nodiscard]] const std::string& source() const override { return file_.source(); }
  [[nodiscard]] const RecordedTopics& topics() const override { return file_.topics(); }

  [[nodiscard]] std::vector<std::string> notes() const override {
    if (file_.whole()) return {};
    return {
        "the recorder was stopped before it finished the file, or the file is cut short or damaged; what "
        "could be read was read"};
  }

  [[nodiscard]] ImageMessage image(const RecordedStream& stream, const RecordedMessage& message,
                                   std::string_view source) const override {
    if (is_compressed(stream.images())) return parse_db3_compressed(file_.read(message), source);
    ImageMessage image = parse_db3_image(file_.read(message), source);
    const KeyValues values = metadata(stream, message);
    const auto number_of = [&](const char* key) {
      const auto found = values.find(key);
      return found == values.end() ? std::nullopt : decimal_number(found->second);
    };
    if (const auto counter = number_of("Frame number"); counter && *counter >= 0.0 && *counter < 1e15)
      image.counter = static_cast<std::uint64_t>(*counter);
    if (const auto time_ms = number_of("timestamp")) image.time_s = 0.001 * *time_ms;
    image.unit_m = number_of("depth_units");
    return image;
  }

  [[nodiscard]] KeyValues metadata(const RecordedStream& stream,
                                   const RecordedMessage& image) const override {
    const std::vector<RecordedMessage> about = messages_at(stream.metadata(), image.time_ns);
    return about.empty() ? KeyValues() : values_of(about.front());
  }

  [[nodiscard]] KeyValues info(const std::string& topic) const override {
    const auto& stated = messages(topic);
    return stated.empty() ? KeyValues() : values_of(stated.front());
  }

  [[nodiscard]] std::map<std::string, double> settings(const std::string& sensor) const override {
    std::map<std::string, double> settings;
    for_each_below(sensor + "option/", [&](std::string_view name, const RecordedMessage& message) {
      const auto setting = setting_of(name);
      if (!setting) return;
      if (const auto value = decimal_number(parse_db3_text(file_.read(message), source())))
        settings[*setting] = *value;
    });
    return settings;
  }

  [[nodiscard]] Intrinsics intrinsics(const RecordedStream& stream) const override {
    const std::string topic = stream.is_of_ros() ? stream.ros_camera_info : stream.name + "/camera_info";
    const auto& stated = messages(topic);
    if (stated.empty()) throw lacks_intrinsics(source(), topic);
    if (stream.is_of_ros())
      return parse_db3_camera_info(file_.read(stated.front()), source() + ", " + printable(topic));
    return intrinsics_from(values_of(stated.front()), source() + ", " + printable(topic));
  }

  [[nodiscard]] std::map<std::string, Transform> stream_from_groups(
      const RecordedStream& stream) const override {
    std::map<std::string, Transform> stream_from_group;
    const std::string beginning = stream.name + "/tf/";
    for_each_below(beginning, [&](std::string_view group, const RecordedMessage& message) {
      stream_from_group.emplace(group, transform_from(values_of(message), source()));
    });
    return stream_from_group;
  }

  [[nodiscard]] std::vector<StaticTransform> static_transforms() const override {
    return transforms_of(messages("/tf_static"), [&](const RecordedMessage& message) {
      return parse_db3_transforms(file_.read(message), source());
    });
  }

 private:
  [[nodiscard]] KeyValues values_of(const RecordedMessage& message) const {
    return parse_db3_values(file_.read(message), source());
  }

  Db3File file_;
};

}  // namespace

std::unique_ptr<Recording> open_db3_recording(const std::filesystem::path& file) {
  return std::make_unique<Db3Recording>(file);
}

}  // namespace rva
