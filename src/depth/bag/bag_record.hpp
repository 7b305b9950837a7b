// The records that a ROS bag of version 2.0 is made of (wiki.ros.org/Bags/Format/2.0).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "depth/bag/ros_bytes.hpp"

namespace rva {

enum class BagOp : std::uint8_t {
  message = 2,
  file_header = 3,
  index = 4,  ///< where one connection's messages lie in the chunk before
  chunk = 5,
  chunk_info = 6,
  connection = 7,
};

/// What the header of a record says; a field that is not there is 0 or empty. Texts lie in the bytes read.
struct BagRecordHeader {
  BagOp op{};
  std::uint32_t connection = 0;
  std::uint32_t count = 0;
  std::uint32_t connection_count = 0;
  std::uint32_t chunk_count = 0;
  std::uint32_t size_bytes = 0;  ///< of a chunk, unpacked
  std::uint64_t index_at = 0;    ///< byte of the file where the index begins; 0 until the recorder ends it
  std::uint64_t chunk_at = 0;    ///< byte of the file where a chunk's record begins
  std::uint64_t time_ns = 0;
  std::string_view topic;
  std::string_view compression;
};

/// A record: its header, and its data.
struct BagRecord {
  BagRecordHeader header;
  std::span<const std::byte> data;
};

/// Takes a whole record off the front.
/// @throws Error when it is not all there, or is no record
[[nodiscard]] BagRecord take_record(RosBytes& bytes, std::string_view place);

/// The fields of a record's header: `name=value`, each behind its length.
/// @throws Error when they are malformed
[[nodiscard]] BagRecordHeader parse_record_header(std::span<const std::byte> fields, std::string_view place);

/// Larger chunks are refused before memory is taken for them: recorders close one at about 1 MB, or behind
/// the message that passes it.
inline constexpr std::uint32_t max_chunk_bytes = 256U << 20U;

/// The records of a chunk.
/// @throws Error when they are damaged, or packed in a way other than LZ4
[[nodiscard]] std::vector<std::byte> unpack_chunk(const BagRecord& chunk, std::string_view place);

}  // namespace rva
