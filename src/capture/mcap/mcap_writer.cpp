#include "capture/mcap/mcap_writer.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <unistd.h>
#include <zstd.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <cerrno>
#include <cstring>
#include <system_error>
#include <type_traits>

#include "capture/mcap/mcap_record.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

using Bytes = std::vector<std::byte>;

// A chunk is one unit of compression and of reading: about two frames of a depth camera.
constexpr std::size_t chunk_bytes = std::size_t{1} << 20U;

template <typename Number>
requires(std::is_integral_v<Number> || std::is_enum_v<Number>) void append(Bytes& bytes, Number value) {
  const auto raw = std::as_bytes(std::span(&value, 1));
  bytes.insert(bytes.end(), raw.begin(), raw.end());
}

void append(Bytes& bytes, std::span<const std::byte> more) {
  bytes.insert(bytes.end(), more.begin(), more.end());
}

void append_text(Bytes& bytes, std::string_view text) {
  append(bytes, static_cast<std::uint32_t>(text.size()));
  append(bytes, std::as_bytes(std::span(text)));
}

Bytes record(McapOp op, std::span<const std::byte> content) {
  Bytes bytes;
  bytes.reserve(mcap_head_bytes + content.size());
  append(bytes, op);
  append(bytes, static_cast<std::uint64_t>(content.size()));
  append(bytes, content);
  return bytes;
}

std::uint32_t crc_of(std::span<const std::byte> bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

Bytes packed(std::span<const std::byte> bytes, const std::filesystem::path& file) {
  constexpr int fast = 1;
  Bytes result(ZSTD_compressBound(bytes.size()));
  const std::size_t size = ZSTD_compress(result.data(), result.size(), bytes.data(), bytes.size(), fast);
  if (ZSTD_isError(size) != 0) throw Error(printable(file), "cannot be compressed", "free some memory");
  result.resize(size);
  return result;
}

}  // namespace

McapWriter::McapWriter(const std::filesystem::path& file, std::string_view profile)
    : path_(file), descriptor_(::open(file.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666)) {
  if (descriptor_ < 0)
    throw Error(printable(file), fmt::format("cannot be created: {}", std::strerror(errno)),
                "choose a folder in which files may be written");
  put(std::as_bytes(std::span(mcap_magic)));
  Bytes header;
  append_text(header, profile);
  append_text(header, "rva");
  put(record(McapOp::header, header));
}

McapWriter::~McapWriter() { ::close(descriptor_); }

McapWriter::Id McapWriter::add_schema(std::string_view name, std::string_view encoding,
                                      std::string_view definition) {
  const auto id = static_cast<Id>(schemas_.size() + 1);
  Bytes content;
  append(content, id);
  append_text(content, name);
  append_text(content, encoding);
  append_text(content, definition);
  schemas_.push_back(record(McapOp::schema, content));
  append(chunk_, schemas_.back());
  return id;
}

McapWriter::Id McapWriter::add_channel(Id schema, std::string_view topic, std::string_view encoding) {
  const auto id = static_cast<Id>(channels_.size());
  Bytes content;
  append(content, id);
  append(content, schema);
  append_text(content, topic);
  append_text(content, encoding);
  append(content, std::uint32_t{0});  // no metadata
  channels_.push_back({.record = record(McapOp::channel, content)});
  append(chunk_, channels_.back().record);
  return id;
}

void McapWriter::write(Id channel, std::uint64_t time_ns, std::span<const std::byte> message) {
  add_to_chunk(channel, time_ns, message);
  if (chunk_.size() >= chunk_bytes) write_chunk();
}

void McapWriter::add_to_chunk(Id channel, std::uint64_t time_ns, std::span<const std::byte> message) {
  range_.first_ns = indices_.empty() ? time_ns : std::min(range_.first_ns, time_ns);
  range_.last_ns = std::max(range_.last_ns, time_ns);
  Bytes& index = indices_[channel];
  append(index, time_ns);
  append(index, static_cast<std::uint64_t>(chunk_.size()));
  Bytes content;
  content.reserve(message.size() + 22);
  append(content, channel);
  append(content, channels_.at(channel).next++);
  append(content, time_ns);
  append(content, time_ns);  // published when it was recorded
  append(content, message);
  append(chunk_, record(McapOp::message, content));
  ++channels_.at(channel).messages;
}

void McapWriter::write_chunk() {
  const Bytes small = packed(chunk_, path_);
  Bytes content;
  append(content, range_.first_ns);
  append(content, range_.last_ns);
  append(content, static_cast<std::uint64_t>(chunk_.size()));
  append(content, crc_of(chunk_));
  append_text(content, "zstd");
  append(content, static_cast<std::uint64_t>(small.size()));
  append(content, small);
  const Bytes whole = record(McapOp::chunk, content);
  range_.at = written_bytes_;
  range_.bytes = whole.size();
  range_.packed_bytes = small.size();
  range_.unpacked_bytes = chunk_.size();
  put(whole);
  const std::uint64_t indices_at = written_bytes_;
  for (const auto& [channel, entries] : indices_) {
    Bytes index;
    append(index, channel);
    append(index, static_cast<std::uint32_t>(entries.size()));
    append(index, entries);
    range_.indices_at[channel] = written_bytes_;
    put(record(McapOp::message_index, index));
  }
  range_.index_bytes = written_bytes_ - indices_at;
  chunks_.push_back(std::move(range_));
  range_ = {};
  chunk_.clear();
  indices_.clear();
}

McapWriter::Bytes McapWriter::statistics() const {
  std::uint64_t messages = 0;
  std::uint64_t first_ns = chunks_.empty() ? 0 : chunks_.front().first_ns;
  std::uint64_t last_ns = 0;
  for (const Channel& channel : channels_) messages += channel.messages;
  for (const ChunkLocation& chunk : chunks_) {
    first_ns = std::min(first_ns, chunk.first_ns);
    last_ns = std::max(last_ns, chunk.last_ns);
  }
  Bytes content;
  append(content, messages);
  append(content, static_cast<std::uint16_t>(schemas_.size()));
  append(content, static_cast<std::uint32_t>(channels_.size()));
  append(content, std::uint32_t{0});  // attachments
  append(content, std::uint32_t{0});  // metadata
  append(content, static_cast<std::uint32_t>(chunks_.size()));
  append(content, first_ns);
  append(content, last_ns);
  Bytes counts;
  for (std::size_t id = 0; id < channels_.size(); ++id) {
    append(counts, static_cast<Id>(id));
    append(counts, channels_[id].messages);
  }
  append(content, static_cast<std::uint32_t>(counts.size()));
  append(content, counts);
  return record(McapOp::statistics, content);
}

McapWriter::Bytes McapWriter::summary() const {
  Bytes bytes;
  for (const Bytes& schema : schemas_) append(bytes, schema);
  for (const Channel& channel : channels_) append(bytes, channel.record);
  append(bytes, statistics());
  for (const ChunkLocation& chunk : chunks_) {
    Bytes content;
    append(content, chunk.first_ns);
    append(content, chunk.last_ns);
    append(content, chunk.at);
    append(content, chunk.bytes);
    Bytes offsets;
    for (const auto& [channel, at] : chunk.indices_at) {
      append(offsets, channel);
      append(offsets, at);
    }
    append(content, static_cast<std::uint32_t>(offsets.size()));
    append(content, offsets);
    append(content, chunk.index_bytes);
    append_text(content, "zstd");
    append(content, chunk.packed_bytes);
    append(content, chunk.unpacked_bytes);
    append(bytes, record(McapOp::chunk_index, content));
  }
  return bytes;
}

void McapWriter::finish() {
  if (!chunk_.empty()) write_chunk();
  Bytes end;
  append(end, std::uint32_t{0});  // no checksum of the data section: each chunk has one
  put(record(McapOp::data_end, end));
  const std::uint64_t summary_at = written_bytes_;
  Bytes tail = summary();
  // The checksum covers the summary and the footer up to the checksum itself.
  append(tail, McapOp::footer);
  append(tail, std::uint64_t{20});
  append(tail, summary_at);
  append(tail, std::uint64_t{0});  // no summary offsets
  append(tail, crc_of(tail));
  put(tail);
  put(std::as_bytes(std::span(mcap_magic)));
  if (::fsync(descriptor_) != 0)
    throw Error(printable(path_), fmt::format("cannot be written: {}", std::strerror(errno)),
                "check the disk");
}

void McapWriter::put(std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ::ssize_t count = ::write(descriptor_, bytes.data(), bytes.size());
    if (count < 0 && errno == EINTR) continue;
    if (count < 0)
      throw Error(printable(path_), fmt::format("cannot be written: {}", std::strerror(errno)),
                  "free some space, or write elsewhere");
    written_bytes_ += static_cast<std::uint64_t>(count);
    bytes = bytes.subspan(static_cast<std::size_t>(count));
  }
}

}  // namespace rva
