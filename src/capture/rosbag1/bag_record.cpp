#include "capture/rosbag1/bag_record.hpp"

#include <fmt/format.h>
#include <lz4frame.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>

#include "core/path_text.hpp"

namespace rva {
namespace {

Error damaged(std::string_view source, const std::string& problem) {
  return {std::string(source), problem, "copy the recording again, or record it again"};
}

struct Lz4Deleter {
  void operator()(LZ4F_dctx* context) const { LZ4F_freeDecompressionContext(context); }
};

std::vector<std::byte> unpack_lz4(std::span<const std::byte> packed, std::size_t size,
                                  std::string_view source) {
  // LZ4 compresses by a factor of 255 at most: a larger stated size is wrong, and no memory is allocated
  // for it.
  if (size / 255 > packed.size()) throw damaged(source, "a chunk is damaged");
  LZ4F_dctx* raw = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&raw, LZ4F_VERSION)) != 0) throw std::bad_alloc();
  const std::unique_ptr<LZ4F_dctx, Lz4Deleter> context(raw);
  std::vector<std::byte> unpacked(size);
  std::size_t done = 0;
  std::size_t hint = 1;  // 0 at the end of the frame
  while (hint != 0 && !packed.empty()) {
    std::size_t made = unpacked.size() - done;
    std::size_t used = packed.size();
    hint = LZ4F_decompress(context.get(), unpacked.data() + done, &made, packed.data(), &used, nullptr);
    if (LZ4F_isError(hint) != 0 || (made == 0 && used == 0)) throw damaged(source, "a chunk is damaged");
    done += made;
    packed = packed.subspan(used);
  }
  if (hint != 0 || done != size) throw damaged(source, "a chunk is damaged");
  return unpacked;
}

// The members that the fields of a header set; other fields are not needed.
struct Field {
  std::string_view name;
  void (*take)(RosBytes& value, BagRecordHeader& header);
};
constexpr auto known_fields = std::to_array<Field>({
    {"op", [](RosBytes& v, BagRecordHeader& h) { h.op = static_cast<BagOp>(v.number<std::uint8_t>()); }},
    {"conn", [](RosBytes& v, BagRecordHeader& h) { h.connection = v.number<std::uint32_t>(); }},
    {"count", [](RosBytes& v, BagRecordHeader& h) { h.count = v.number<std::uint32_t>(); }},
    {"conn_count", [](RosBytes& v, BagRecordHeader& h) { h.connection_count = v.number<std::uint32_t>(); }},
    {"chunk_count", [](RosBytes& v, BagRecordHeader& h) { h.chunk_count = v.number<std::uint32_t>(); }},
    {"size", [](RosBytes& v, BagRecordHeader& h) { h.size_bytes = v.number<std::uint32_t>(); }},
    {"index_pos", [](RosBytes& v, BagRecordHeader& h) { h.index_at = v.number<std::uint64_t>(); }},
    {"chunk_pos", [](RosBytes& v, BagRecordHeader& h) { h.chunk_at = v.number<std::uint64_t>(); }},
    {"time", [](RosBytes& v, BagRecordHeader& h) { h.time_ns = v.time_ns(); }},
    {"topic", [](RosBytes& v, BagRecordHeader& h) { h.topic = v.rest(); }},
    {"compression", [](RosBytes& v, BagRecordHeader& h) { h.compression = v.rest(); }},
});

}  // namespace

BagRecordHeader parse_record_header(std::span<const std::byte> fields, std::string_view source) {
  BagRecordHeader header;
  RosBytes bytes(fields, source);
  while (bytes.left() > 0) {
    const std::string_view field = bytes.text();
    const std::size_t equals = field.find('=');
    if (equals == std::string_view::npos) throw damaged(source, "a record's header is damaged");
    const std::string_view name = field.substr(0, equals);
    const std::string_view text = field.substr(equals + 1);
    RosBytes value(std::as_bytes(std::span(text)), source);
    const auto* known = std::ranges::find(known_fields, name, &Field::name);
    if (known != known_fields.end()) known->take(value, header);
  }
  return header;
}

BagRecord take_record(RosBytes& bytes, std::string_view source) {
  const auto fields = bytes.list_of_bytes();
  return {parse_record_header(fields, source), bytes.list_of_bytes()};
}

std::vector<std::byte> unpack_chunk(const BagRecord& chunk, std::string_view source) {
  const std::uint32_t size = chunk.header.size_bytes;
  if (size > max_chunk_bytes) throw damaged(source, fmt::format("a chunk states {} MB", size >> 20U));
  if (chunk.header.compression == "lz4") return unpack_lz4(chunk.data, size, source);
  if (chunk.header.compression != "none") {
    throw Error(std::string(source),
                fmt::format("its chunks are compressed with '{}'", printable(chunk.header.compression)),
                "decompress it with `rosbag decompress`");
  }
  if (chunk.data.size() != size) throw damaged(source, "a chunk is damaged");
  return {chunk.data.begin(), chunk.data.end()};
}

}  // namespace rva
