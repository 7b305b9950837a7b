#include "capture/mcap/mcap_index.hpp"

#include <algorithm>
#include <optional>
#include <utility>

#include "capture/mcap/mcap_record.hpp"
#include "core/error.hpp"
#include "core/interrupt.hpp"

namespace rva {
namespace {

constexpr std::size_t footer_bytes = mcap_head_bytes + 20;

bool is_magic(std::span<const std::byte> bytes) {
  return std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()) == mcap_magic;
}

/// A chunk, as the index at the end of the file states it.
struct ChunkLocation {
  std::uint64_t at = 0;
  std::uint64_t bytes = 0;
  std::uint64_t index_bytes = 0;  ///< of the message indices that follow it
};

ChunkLocation parse_chunk_index(std::span<const std::byte> content, const std::string& source) {
  RosBytes bytes(content, source);
  static_cast<void>(bytes.number<std::uint64_t>());  // times of the first and the last message
  static_cast<void>(bytes.number<std::uint64_t>());
  ChunkLocation chunk;
  chunk.at = bytes.number<std::uint64_t>();
  chunk.bytes = bytes.number<std::uint64_t>();
  static_cast<void>(bytes.list_of_bytes());  // where each channel's index lies
  chunk.index_bytes = bytes.number<std::uint64_t>();
  return chunk;
}

/// Collects schemas, channels and messages in the order of the file.
class Builder {
 public:
  Builder(const OpenFile& file, const std::string& source) : file_(file), source_(source) {}

  // @param at byte of the file where the chunk, or a record outside chunks, begins
  // @param offset of the record in the decompressed chunk
  void add(const McapRecord& record, std::uint64_t at, std::size_t offset) {
    if (record.op == McapOp::schema) add_schema(record.content);
    if (record.op == McapOp::channel) add_channel(record.content);
    if (record.op == McapOp::message) {
      const McapMessage message = parse_mcap_message(record.content, source_);
      add_message(message.channel, {message.time_ns, at, static_cast<std::uint32_t>(offset)});
    }
  }

  // If the chunk is damaged, the records that could not be read are left out, and the chunk is counted.
  void add_chunk(std::span<const std::byte> content, std::uint64_t at) {
    try {
      const std::vector<std::byte> records = unpack_mcap_chunk(content, source_);
      RosBytes bytes(records, source_);
      while (bytes.left() > 0) {
        const std::size_t offset = records.size() - bytes.left();
        add(take_mcap_record(bytes, source_), at, offset);
      }
    } catch (const Error&) {
      ++index_.damaged_chunks;
    }
  }

  // The messages of the chunk that the end of the file cuts: whole ones are read, the last one is not.
  void add_cut_chunk(std::uint64_t at) {
    try {
      const std::vector<std::byte> records = read_mcap_records(file_, at, source_);
      RosBytes bytes(records, source_);
      while (bytes.left() > 0) {
        const std::size_t offset = records.size() - bytes.left();
        add(take_mcap_record(bytes, source_), at, offset);
      }
    } catch (const Error&) {  // the end of what is there
    }
  }

  // Whether the schema of a channel is known; channels without a schema have the number 0.
  [[nodiscard]] bool knows_schema_of(std::span<const std::byte> channel) const {
    const std::uint16_t schema = parse_mcap_channel(channel, source_).schema;
    return schema == 0 || schemas_.contains(schema);
  }

  void add_schemas_of(const ChunkLocation& chunk) {
    const std::vector<std::byte> record = read_mcap_record(file_, chunk.at, source_);
    const std::vector<std::byte> records =
        unpack_mcap_chunk(std::span(record).subspan(mcap_head_bytes), source_);
    RosBytes bytes(records, source_);
    while (bytes.left() > 0) {
      const McapRecord inner = take_mcap_record(bytes, source_);
      if (inner.op == McapOp::schema) add_schema(inner.content);
    }
  }

  // A chunk without message indices is decompressed instead.
  void add_indexed(const ChunkLocation& chunk) {
    throw_if_interrupted();
    if (chunk.index_bytes == 0) {
      const std::vector<std::byte> record = read_mcap_record(file_, chunk.at, source_);
      add_chunk(std::span(record).subspan(mcap_head_bytes), chunk.at);
      return;
    }
    constexpr std::uint64_t most_index_bytes = 256ULL << 20U;
    if (chunk.index_bytes > most_index_bytes) throw damaged_index();
    const std::vector<std::byte> indices =
        file_.read(chunk.at + chunk.bytes, static_cast<std::size_t>(chunk.index_bytes));
    RosBytes bytes(indices, source_);
    while (bytes.left() > 0) {
      const McapRecord record = take_mcap_record(bytes, source_);
      if (record.op == McapOp::message_index) add_message_index(record.content, chunk.at);
    }
  }

  [[nodiscard]] McapIndex take() {
    for (auto& [name, topic] : index_.topics)
      std::ranges::stable_sort(topic.messages, {}, &RecordedMessage::time_ns);
    return std::move(index_);
  }

  void set_unfinished() { index_.finished = false; }

 private:
  [[nodiscard]] Error damaged_index() const {
    return {source_, "its index is damaged", "copy it again, or record it again"};
  }

  void add_schema(std::span<const std::byte> content) {
    RosBytes bytes(content, source_);
    const auto id = bytes.number<std::uint16_t>();
    schemas_[id] = bytes.text();
  }

  void add_channel(std::span<const std::byte> content) {
    McapChannel channel = parse_mcap_channel(content, source_);
    RecordedTopic& topic = index_.topics[channel.topic];
    topic.type = schemas_[channel.schema];
    index_.encodings[channel.topic] = channel.encoding;
    topics_[channel.id] = &topic;
  }

  void add_message(std::uint16_t channel, RecordedMessage message) {
    const auto topic = topics_.find(channel);
    if (topic != topics_.end()) topic->second->messages.push_back(message);
  }

  void add_message_index(std::span<const std::byte> content, std::uint64_t at) {
    RosBytes bytes(content, source_);
    const auto channel = bytes.number<std::uint16_t>();
    if (!topics_.contains(channel))
      throw damaged_index();  // not every recorder repeats channels in the summary
    RosBytes entries(bytes.list_of_bytes(), source_);
    while (entries.left() > 0) {
      const auto time_ns = entries.number<std::uint64_t>();
      const auto offset = entries.number<std::uint64_t>();
      add_message(channel, {time_ns, at, static_cast<std::uint32_t>(offset)});
    }
  }

  const OpenFile& file_;
  const std::string& source_;
  McapIndex index_;
  std::map<std::uint16_t, std::string> schemas_;
  std::map<std::uint16_t, RecordedTopic*> topics_;
};

// The summary section, between the data and the footer; empty where the recorder wrote none.
std::vector<std::byte> read_summary(const OpenFile& file, const std::string& source) {
  constexpr std::uint64_t most_summary_bytes = 512ULL << 20U;
  const std::uint64_t tail_bytes = footer_bytes + mcap_magic.size();
  if (file.size_bytes() < mcap_magic.size() + tail_bytes) return {};
  const std::uint64_t footer_at = file.size_bytes() - tail_bytes;
  const std::vector<std::byte> tail = file.read(footer_at, tail_bytes);
  if (!is_magic(std::span(tail).subspan(footer_bytes))) return {};
  RosBytes bytes(tail, source);
  if (static_cast<McapOp>(bytes.number<std::uint8_t>()) != McapOp::footer) return {};
  static_cast<void>(bytes.number<std::uint64_t>());
  const auto summary_at = bytes.number<std::uint64_t>();
  if (summary_at == 0 || summary_at > footer_at || footer_at - summary_at > most_summary_bytes) return {};
  return file.read(summary_at, static_cast<std::size_t>(footer_at - summary_at));
}

// Empty when the summary lists no chunks: messages may then be outside chunks.
std::optional<McapIndex> from_summary(const OpenFile& file, const std::string& source) {
  const std::vector<std::byte> summary = read_summary(file, source);
  Builder builder(file, source);
  std::vector<ChunkLocation> chunks;
  std::vector<McapRecord> channels;
  RosBytes bytes(summary, source);
  while (bytes.left() > 0) {
    const McapRecord record = take_mcap_record(bytes, source);
    if (record.op == McapOp::chunk_index)
      chunks.push_back(parse_chunk_index(record.content, source));
    else if (record.op == McapOp::channel)
      channels.push_back(record);
    else
      builder.add(record, 0, 0);
  }
  if (chunks.empty()) return std::nullopt;
  // Not every recorder repeats schemas in the summary: they precede the first message of their channel.
  const auto all_known = [&] {
    return std::ranges::all_of(
        channels, [&](const McapRecord& channel) { return builder.knows_schema_of(channel.content); });
  };
  for (auto chunk = chunks.begin(); chunk != chunks.end() && !all_known(); ++chunk)
    builder.add_schemas_of(*chunk);
  for (const McapRecord& channel : channels) builder.add(channel, 0, 0);
  for (const ChunkLocation& chunk : chunks) builder.add_indexed(chunk);
  return builder.take();
}

McapIndex from_records(const OpenFile& file, const std::string& source) {
  Builder builder(file, source);
  bool ended = false;
  for (std::uint64_t at = mcap_magic.size(); at < file.size_bytes() && !ended;) {
    throw_if_interrupted();
    std::vector<std::byte> record;
    try {
      record = read_mcap_record(file, at, source);
    } catch (const Error&) {
      builder.add_cut_chunk(at);
      break;
    }
    const auto op = static_cast<McapOp>(record.front());
    const auto content = std::span<const std::byte>(record).subspan(mcap_head_bytes);
    if (op == McapOp::chunk)
      builder.add_chunk(content, at);
    else
      builder.add({op, content}, at, 0);
    ended = op == McapOp::data_end;
    at += record.size();
  }
  if (!ended) builder.set_unfinished();
  return builder.take();
}

}  // namespace

std::vector<std::byte> read_mcap_record(const OpenFile& file, std::uint64_t at, const std::string& source) {
  constexpr std::uint64_t most_record_bytes = 1ULL << 30U;
  const std::vector<std::byte> head = file.read(at, mcap_head_bytes);
  RosBytes bytes(head, source);
  static_cast<void>(bytes.number<std::uint8_t>());
  const auto length = bytes.number<std::uint64_t>();
  if (length > most_record_bytes || at + mcap_head_bytes + length > file.size_bytes())
    throw Error(source, "the recording is damaged: a record ends early", "copy it again, or record it again");
  return file.read(at, mcap_head_bytes + static_cast<std::size_t>(length));
}

std::vector<std::byte> read_mcap_records(const OpenFile& file, std::uint64_t at, const std::string& source) {
  const std::vector<std::byte> head = file.read(at, mcap_head_bytes);
  RosBytes bytes(head, source);
  const auto op = static_cast<McapOp>(bytes.number<std::uint8_t>());
  const auto length = bytes.number<std::uint64_t>();
  if (op != McapOp::chunk) return read_mcap_record(file, at, source);
  const std::uint64_t left = file.size_bytes() - at - mcap_head_bytes;
  if (length > left) {
    constexpr std::uint64_t most_cut_bytes = 256ULL << 20U;  // more than any chunk
    return unpack_cut_mcap_chunk(
        file.read(at + mcap_head_bytes, static_cast<std::size_t>(std::min(left, most_cut_bytes))), source);
  }
  const std::vector<std::byte> record = read_mcap_record(file, at, source);
  return unpack_mcap_chunk(std::span(record).subspan(mcap_head_bytes), source);
}

McapIndex read_mcap_index(const OpenFile& file, const std::string& source) {
  if (!is_magic(file.read(0, mcap_magic.size()))) throw Error(source, "not an MCAP file", "give a recording");
  try {
    if (auto index = from_summary(file, source)) return std::move(*index);
  } catch (const Error&) {  // the index is damaged: messages are found without it
  }
  return from_records(file, source);
}

}  // namespace rva
