#include "capture/mcap/mcap_record.hpp"

#include <fmt/format.h>
#include <lz4frame.h>
#include <zstd.h>

#include <algorithm>
#include <boost/crc.hpp>
#include <memory>

#include "core/error.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

// No recorder makes larger chunks: one that states a larger size is damaged.
constexpr std::uint64_t most_chunk_bytes = 128ULL << 20U;

Error damaged(std::string_view source, const std::string& how) {
  return {std::string(source), "the recording is damaged: " + how, "copy it again, or record it again"};
}

/// Decompresses until `size` bytes are there or the input ends. An input that ends early gives fewer bytes.
std::vector<std::byte> unpack_lz4(std::span<const std::byte> packed, std::size_t size,
                                  std::string_view source) {
  LZ4F_dctx* context = nullptr;
  if (LZ4F_isError(LZ4F_createDecompressionContext(&context, LZ4F_VERSION)) != 0)
    throw Error(std::string(source), "cannot be decompressed", "free some memory");
  const std::unique_ptr<LZ4F_dctx, decltype(&LZ4F_freeDecompressionContext)> owned(
      context, &LZ4F_freeDecompressionContext);
  std::vector<std::byte> unpacked(size);
  std::size_t taken = 0;
  std::size_t made = 0;
  while (made < size) {
    std::size_t room = size - made;
    std::size_t given = packed.size() - taken;
    const std::size_t more =
        LZ4F_decompress(context, unpacked.data() + made, &room, packed.data() + taken, &given, nullptr);
    if (LZ4F_isError(more) != 0) throw damaged(source, "a chunk cannot be decompressed");
    if (room == 0 && given == 0) break;
    made += room;
    taken += given;
  }
  unpacked.resize(made);
  return unpacked;
}

/// Likewise.
std::vector<std::byte> unpack_zstd(std::span<const std::byte> packed, std::size_t size,
                                   std::string_view source) {
  const std::unique_ptr<ZSTD_DStream, decltype(&ZSTD_freeDStream)> stream(ZSTD_createDStream(),
                                                                          &ZSTD_freeDStream);
  if (!stream) throw Error(std::string(source), "cannot be decompressed", "free some memory");
  std::vector<std::byte> unpacked(size);
  ZSTD_inBuffer input{packed.data(), packed.size(), 0};
  ZSTD_outBuffer output{unpacked.data(), unpacked.size(), 0};
  while (output.pos < output.size) {
    const std::size_t before = output.pos;
    const bool all_taken = input.pos == input.size;
    if (ZSTD_isError(ZSTD_decompressStream(stream.get(), &output, &input)) != 0)
      throw damaged(source, "a chunk cannot be decompressed");
    if (all_taken && output.pos == before) break;
  }
  unpacked.resize(output.pos);
  return unpacked;
}

std::vector<std::byte> unpacked(std::string_view compression, std::span<const std::byte> packed,
                                std::size_t size, std::string_view source) {
  if (compression == "lz4") return unpack_lz4(packed, size, source);
  if (compression == "zstd") return unpack_zstd(packed, size, source);
  if (!compression.empty())
    throw Error(std::string(source),
                fmt::format("its chunks are compressed with '{}'", printable(compression)),
                "compress them with lz4 or zstd, or not at all");
  const auto there = packed.first(std::min(packed.size(), size));
  return {there.begin(), there.end()};
}

/// What precedes the records of a chunk.
struct ChunkHead {
  std::uint64_t size = 0;  ///< of the records
  std::uint32_t check_sum = 0;
  std::string_view compression;
  std::uint64_t packed_size = 0;
};

ChunkHead take_chunk_head(RosBytes& bytes, std::string_view source) {
  static_cast<void>(bytes.number<std::uint64_t>());  // times of the first and the last message
  static_cast<void>(bytes.number<std::uint64_t>());
  ChunkHead head;
  head.size = bytes.number<std::uint64_t>();
  head.check_sum = bytes.number<std::uint32_t>();
  head.compression = bytes.text();
  head.packed_size = bytes.number<std::uint64_t>();
  if (head.size > most_chunk_bytes) throw damaged(source, "a chunk states an impossible length");
  return head;
}

}  // namespace

McapRecord take_mcap_record(RosBytes& bytes, std::string_view source) {
  const auto op = static_cast<McapOp>(bytes.number<std::uint8_t>());
  const auto length = bytes.number<std::uint64_t>();
  if (length > bytes.left()) throw damaged(source, "a record ends early");
  return {op, bytes.take(static_cast<std::size_t>(length))};
}

McapChannel parse_mcap_channel(std::span<const std::byte> content, std::string_view source) {
  RosBytes bytes(content, source);
  McapChannel channel;
  channel.id = bytes.number<std::uint16_t>();
  channel.schema = bytes.number<std::uint16_t>();
  channel.topic = bytes.text();
  channel.encoding = bytes.text();
  return channel;
}

McapMessage parse_mcap_message(std::span<const std::byte> content, std::string_view source) {
  RosBytes bytes(content, source);
  McapMessage message;
  message.channel = bytes.number<std::uint16_t>();
  static_cast<void>(bytes.number<std::uint32_t>());  // sequence
  message.time_ns = bytes.number<std::uint64_t>();
  static_cast<void>(bytes.number<std::uint64_t>());  // when it was published
  message.data = bytes.take(bytes.left());
  return message;
}

std::vector<std::byte> unpack_mcap_chunk(std::span<const std::byte> content, std::string_view source) {
  RosBytes bytes(content, source);
  const ChunkHead head = take_chunk_head(bytes, source);
  if (head.packed_size > bytes.left()) throw damaged(source, "a chunk states an impossible length");
  std::vector<std::byte> records =
      unpacked(head.compression, bytes.take(static_cast<std::size_t>(head.packed_size)),
               static_cast<std::size_t>(head.size), source);
  if (records.size() != head.size) throw damaged(source, "a chunk does not have its stated length");
  if (head.check_sum != 0) {
    boost::crc_32_type crc;
    crc.process_bytes(records.data(), records.size());
    if (crc.checksum() != head.check_sum) throw damaged(source, "the checksum of a chunk does not match");
  }
  return records;
}

std::vector<std::byte> unpack_cut_mcap_chunk(std::span<const std::byte> content, std::string_view source) {
  RosBytes bytes(content, source);
  const ChunkHead head = take_chunk_head(bytes, source);
  return unpacked(head.compression, bytes.take(bytes.left()), static_cast<std::size_t>(head.size), source);
}

}  // namespace rva
