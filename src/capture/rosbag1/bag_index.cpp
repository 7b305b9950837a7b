#include "capture/rosbag1/bag_index.hpp"

#include <algorithm>
#include <set>
#include <string_view>

#include "core/error.hpp"
#include "core/interrupt.hpp"

namespace rva {
namespace {

constexpr std::string_view version_line = "#ROSBAG V2.0\n";
constexpr std::uint32_t max_header_bytes = 1U << 20U;

Error damaged(const std::string& source) {
  return {source, "the recording is damaged", "copy it again, or record it again"};
}

/// Collects connections and messages in any order.
class Gathering {
 public:
  void connect(std::uint32_t connection, std::string_view topic, std::string_view type) {
    topics_.try_emplace(connection, topic, type);
  }

  void add(std::uint32_t connection, const RecordedMessage& message) {
    messages_[connection].push_back(message);
  }

  [[nodiscard]] RecordedTopics by_topic() && {
    RecordedTopics topics;
    for (const auto& [connection, topic] : topics_) {
      RecordedTopic& stream = topics[topic.first];
      stream.type = topic.second;
      const std::vector<RecordedMessage>& more = messages_[connection];
      stream.messages.insert(stream.messages.end(), more.begin(), more.end());
    }
    for (auto& [name, topic] : topics)
      std::ranges::stable_sort(topic.messages, {}, &RecordedMessage::time_ns);
    return topics;
  }

 private:
  std::map<std::uint32_t, std::pair<std::string, std::string>> topics_;
  std::map<std::uint32_t, std::vector<RecordedMessage>> messages_;
};

// The data of a connection record are fields as well, of which only the type is needed.
void add_connection(const BagRecordHeader& header, std::span<const std::byte> data, const std::string& source,
                    Gathering& found) {
  constexpr std::string_view type = "type=";
  RosBytes fields(data, source);
  while (fields.left() > 0) {
    const std::string_view field = fields.text();
    if (field.starts_with(type)) found.connect(header.connection, header.topic, field.substr(type.size()));
  }
}

void add_connection(const OpenFile& file, const BagRecordLocation& record, const std::string& source,
                    Gathering& found) {
  if (record.data_bytes > max_header_bytes) throw damaged(source);
  add_connection(record.header, file.read(record.data_at, record.data_bytes), source, found);
}

// A chunk is followed by its index records, one for each connection.
void add_indexed_chunk(const OpenFile& file, std::uint64_t chunk_at, const std::string& source,
                       Gathering& found) {
  BagRecordLocation record = find_record(file, chunk_at, source);
  if (record.header.op != BagOp::chunk) throw damaged(source);
  while (record.end() < file.size_bytes()) {
    record = find_record(file, record.end(), source);
    if (record.header.op != BagOp::index) return;
    const std::vector<std::byte> data = file.read(record.data_at, record.data_bytes);
    RosBytes entries(data, source);
    for (std::uint32_t i = 0; i < record.header.count; ++i) {
      const std::uint64_t time_ns = entries.time_ns();
      found.add(record.header.connection, {time_ns, chunk_at, entries.number<std::uint32_t>()});
    }
  }
}

BagIndex read_index(const OpenFile& file, const BagRecordHeader& bag, const std::string& source) {
  Gathering found;
  std::set<std::uint64_t> chunks;
  std::uint64_t at = bag.index_at;
  for (std::uint64_t i = 0; i < std::uint64_t{bag.connection_count} + bag.chunk_count; ++i) {
    throw_if_interrupted();
    const BagRecordLocation record = find_record(file, at, source);
    if (record.header.op == BagOp::connection)
      add_connection(file, record, source, found);
    else if (record.header.op != BagOp::chunk_info)
      throw damaged(source);
    else if (chunks.insert(record.header.chunk_at).second)
      add_indexed_chunk(file, record.header.chunk_at, source, found);
    at = record.end();
  }
  return {.topics = std::move(found).by_topic()};
}

void add_scanned_chunk(const OpenFile& file, std::uint64_t at, const std::string& source, Gathering& found) {
  const std::vector<std::byte> records = read_chunk(file, at, source);
  RosBytes rest(records, source);
  while (rest.left() > 0) {
    const auto offset = static_cast<std::uint32_t>(records.size() - rest.left());
    const BagRecord record = take_record(rest, source);
    if (record.header.op == BagOp::connection) add_connection(record.header, record.data, source, found);
    if (record.header.op == BagOp::message)
      found.add(record.header.connection, {record.header.time_ns, at, offset});
  }
}

BagIndex scan(const OpenFile& file, std::uint64_t at, const std::string& source) {
  BagIndex index{.topics = {}, .finished = false};
  Gathering found;
  try {
    while (at < file.size_bytes()) {
      throw_if_interrupted();
      const BagRecordLocation record = find_record(file, at, source);
      if (record.end() > file.size_bytes()) break;
      if (record.header.op == BagOp::chunk) {
        try {
          add_scanned_chunk(file, at, source, found);
        } catch (const Error&) {
          ++index.damaged_chunks;
        }
      }
      at = record.end();
    }
  } catch (const Error&) {
    // What follows is not a record: the recorder was interrupted here.
  }
  index.topics = std::move(found).by_topic();
  return index;
}

}  // namespace

BagRecordLocation find_record(const OpenFile& file, std::uint64_t at, const std::string& source) {
  constexpr std::size_t length_bytes = sizeof(std::uint32_t);
  const std::vector<std::byte> length = file.read(at, length_bytes);
  const auto header_bytes = RosBytes(length, source).number<std::uint32_t>();
  if (header_bytes > max_header_bytes) throw damaged(source);
  BagRecordLocation record;
  record.fields = file.read(at + length_bytes, header_bytes + length_bytes);
  RosBytes bytes(record.fields, source);
  record.header = parse_record_header(bytes.take(header_bytes), source);
  record.data_bytes = bytes.number<std::uint32_t>();
  record.data_at = at + 2 * length_bytes + header_bytes;
  return record;
}

std::vector<std::byte> read_chunk(const OpenFile& file, std::uint64_t at, const std::string& source) {
  const BagRecordLocation record = find_record(file, at, source);
  if (record.header.op != BagOp::chunk || record.data_bytes > max_chunk_bytes) throw damaged(source);
  const std::vector<std::byte> data = file.read(record.data_at, record.data_bytes);
  return unpack_chunk({record.header, data}, source);
}

BagIndex read_bag_index(const OpenFile& file, const std::string& source) {
  const std::vector<std::byte> line = file.read(0, version_line.size());
  if (!std::ranges::equal(line, std::as_bytes(std::span(version_line)))) {
    throw Error(source, "not a ROS bag of version 2.0",
                "give a recording of realsense-viewer, or the folder of a capture");
  }
  const BagRecordLocation bag = find_record(file, version_line.size(), source);
  if (bag.header.op != BagOp::file_header) throw damaged(source);
  if (bag.header.index_at > 0) {
    try {
      return read_index(file, bag.header, source);
    } catch (const Error&) {
      // The index is truncated or damaged: the chunks are scanned instead.
    }
  }
  return scan(file, bag.end(), source);
}

}  // namespace rva
