#include "capture/mcap/mcap_record.hpp"

#include <fmt/format.h>
#include <lz4frame.h>
#include <zstd.h>

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
    if (LZ4F_isError(more) != 0 || (room == 0 && given == 0))
      throw damaged(source, "a chunk cannot be decompressed");
    made += room;
    taken += given;
  }
  return unpacked;
}

std::vector<std::byte> unpack_zstd(std::span<const std::byte> packed, std::size_t size,
                                   std::string_view source) {
  std::vector<std::byte> unpacked(size);
  const std::size_t made = ZSTD_decompress(unpacked.data(), size, packed.data(), packed.size());
  if (ZSTD_isError(made) != 0 || made != size) throw damaged(source, "a chunk cannot be decompressed");
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
  if (packed.size() != size) throw damaged(source, "a chunk does not have its stated length");
  return {packed.begin(), packed.end()};
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
  static_cast<void>(bytes.number<std::uint64_t>());  // times of the first and the last message
  static_cast<void>(bytes.number<std::uint64_t>());
  const auto size = bytes.number<std::uint64_t>();
  const auto check_sum = bytes.number<std::uint32_t>();
  const std::string_view compression = bytes.text();
  const auto length = bytes.number<std::uint64_t>();
  if (size > most_chunk_bytes || length > bytes.left())
    throw damaged(source, "a chunk states an impossible length");
  std::vector<std::byte> records = unpacked(compression, bytes.take(static_cast<std::size_t>(length)),
                                            static_cast<std::size_t>(size), source);
  if (check_sum != 0) {
    boost::crc_32_type crc;
    crc.process_bytes(records.data(), records.size());
    if (crc.checksum() != check_sum) throw damaged(source, "the checksum of a chunk does not match");
  }
  return records;
}

}  // namespace rva
