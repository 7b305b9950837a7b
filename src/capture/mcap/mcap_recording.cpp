#include "capture/mcap/mcap_recording.hpp"

#include <fmt/format.h>

#include "capture/file_kind.hpp"
#include "capture/mcap/mcap_index.hpp"
#include "capture/mcap/mcap_record.hpp"
#include "capture/recording/recent_chunks.hpp"
#include "capture/rosbag1/bag_messages.hpp"
#include "capture/rosbag2/db3_messages.hpp"
#include "core/error.hpp"
#include "core/file.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

class McapRecording : public Recording {
 public:
  explicit McapRecording(const std::filesystem::path& path)
      : file_(path), source_(printable(path)), index_(read_mcap_index(file_, source_)) {}

  [[nodiscard]] std::string_view format() const override { return "mcap"; }
  [[nodiscard]] const std::string& source() const override { return source_; }
  [[nodiscard]] const RecordedTopics& topics() const override { return index_.topics; }

  [[nodiscard]] std::vector<std::string> notes() const override {
    std::vector<std::string> notes;
    if (!index_.finished)
      notes.emplace_back(
          "the recorder was stopped before it finished the file, or the file is cut short; what is complete "
          "was read");
    if (index_.damaged_chunks > 0)
      notes.push_back(fmt::format("{} damaged part(s) of the file were left out", index_.damaged_chunks));
    return notes;
  }

  [[nodiscard]] ImageMessage image(const RecordedStream& stream, const RecordedMessage& message,
                                   std::string_view source) const override {
    const std::string topic = stream.images();
    const bool of_ros1 = is_of_ros1(topic);
    if (is_compressed(topic))
      return of_ros1 ? parse_compressed_message(read(message), source)
                     : parse_db3_compressed(read(message), source);
    return of_ros1 ? parse_image_message(read(message), source) : parse_db3_image(read(message), source);
  }

  [[nodiscard]] Intrinsics intrinsics(const RecordedStream& stream) const override {
    const std::string& topic = stream.ros_camera_info;
    const auto& stated = messages(topic);
    if (stated.empty()) throw lacks_intrinsics(source(), topic);
    const std::string where = source() + ", " + printable(topic);
    return is_of_ros1(topic) ? parse_camera_info(read(stated.front()), where)
                             : parse_db3_camera_info(read(stated.front()), where);
  }

  [[nodiscard]] std::string text(const RecordedMessage& message, std::string_view topic) const override {
    const auto encoding = index_.encodings.find(topic);
    if (encoding == index_.encodings.end() || encoding->second != "json") return {};
    const std::vector<std::byte> bytes = read(message);
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }

  // Only librealsense's recordings have metadata, device information, settings and transforms.
  [[nodiscard]] KeyValues metadata(const RecordedStream& /*stream*/,
                                   const RecordedMessage& /*image*/) const override {
    return {};
  }
  [[nodiscard]] KeyValues info(const std::string& /*topic*/) const override { return {}; }
  [[nodiscard]] std::map<std::string, double> settings(const std::string& /*sensor*/) const override {
    return {};
  }
  [[nodiscard]] std::map<std::string, Transform> stream_from_groups(
      const RecordedStream& /*stream*/) const override {
    return {};
  }

  [[nodiscard]] std::vector<StaticTransform> static_transforms() const override {
    const bool of_ros1 = is_of_ros1("/tf_static");
    return transforms_of(messages("/tf_static"), [&](const RecordedMessage& message) {
      const std::vector<std::byte> bytes = read(message);
      return of_ros1 ? parse_transforms(bytes, source_) : parse_db3_transforms(bytes, source_);
    });
  }

 private:
  [[nodiscard]] bool is_of_ros1(std::string_view topic) const {
    const auto encoding = index_.encodings.find(topic);
    return encoding != index_.encodings.end() && encoding->second == "ros1";
  }

  [[nodiscard]] std::vector<std::byte> read(const RecordedMessage& message) const {
    const RecentChunks::Chunk records =
        chunks_.get(message.at, [&] { return read_mcap_records(file_, message.at, source_); });
    if (message.offset > records->size()) throw damaged_index();
    const std::span<const std::byte> all(*records);
    RosBytes bytes(all.subspan(message.offset), source_);
    const McapRecord record = take_mcap_record(bytes, source_);
    if (record.op != McapOp::message) throw damaged_index();
    const McapMessage content = parse_mcap_message(record.content, source_);
    return {content.data.begin(), content.data.end()};
  }

  [[nodiscard]] Error damaged_index() const {
    return {source_, "its index is damaged", "copy it again, or record it again"};
  }

  OpenFile file_;
  std::string source_;
  McapIndex index_;
  mutable RecentChunks chunks_;
};

}  // namespace

bool is_mcap_file(const std::filesystem::path& path) { return begins_with(path, mcap_magic); }

std::unique_ptr<Recording> open_mcap_recording(const std::filesystem::path& file) {
  return std::make_unique<McapRecording>(file);
}

}  // namespace rva
