// The records that a ROS bag of version 2.0 is made of (wiki.ros.org/Bags/Format/2.0).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "capture/rosbag1/ros_bytes.hpp"

namespace rva {

/// The kinds of records of a ROS 1 bag, by their `op` field.
enum class BagOp : std::uint8_t {
  message = 2,
  file_header = 3,
  index = 4,  ///< positions of one connection's messages in the chunk before
  chunk = 5,
  chunk_info = 6,
  connection = 7,
};

/// The header of a record; missing fields are 0 or empty. Texts refer to the bytes that were parsed.
struct BagRecordHeader {
  BagOp op{};                          ///< opcode
  std::uint32_t connection = 0;        ///< number of the connection that a message or an index belongs to
  std::uint32_t count = 0;             ///< number of entries in an index or a chunk's summary
  std::uint32_t connection_count = 0;  ///< number of connections in the bag
  std::uint32_t chunk_count = 0;       ///< number of chunks in the bag
  std::uint32_t size_bytes = 0;        ///< of a chunk when decompressed
  std::uint64_t index_at = 0;          ///< byte of the file where the index begins; 0 if it is unfinished
  std::uint64_t chunk_at = 0;          ///< byte of the file where a chunk's record begins
  std::uint64_t time_ns = 0;           ///< recording time of a message, nanoseconds
  std::string_view topic;              ///< of a connection's messages
  std::string_view compression;        ///< of a chunk: "none", "lz4", "bz2"
};

/// A record: its header, and its data.
struct BagRecord {
  BagRecordHeader header;           ///< its texts refer to the bytes from which it was taken
  std::span<const std::byte> data;  ///< refers to the bytes from which it was taken
};

/// Takes a record from the front of the bytes.
/// @throws Error when it is incomplete or malformed
[[nodiscard]] BagRecord take_record(RosBytes& bytes, std::string_view source);

/// Parses the fields of a record's header: `name=value`, each preceded by its length.
/// @throws Error when they are malformed
[[nodiscard]] BagRecordHeader parse_record_header(std::span<const std::byte> fields, std::string_view source);

/// Larger chunks are refused before memory is allocated for them: recorders end a chunk at about 1 MB, or
/// after the message that exceeds this.
inline constexpr std::uint32_t max_chunk_bytes = 256U << 20U;

/// Decompresses the records of a chunk.
/// @throws Error when they are damaged, or compressed by anything but LZ4
[[nodiscard]] std::vector<std::byte> unpack_chunk(const BagRecord& chunk, std::string_view source);

}  // namespace rva
