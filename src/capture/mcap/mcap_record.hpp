// The records that an MCAP file consists of (mcap.dev/spec, version 0).
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "capture/rosbag1/ros_bytes.hpp"

namespace rva {

/// The kinds of MCAP records that are read, by their opcode.
enum class McapOp : std::uint8_t {
  header = 0x01,
  footer = 0x02,
  schema = 0x03,
  channel = 0x04,
  message = 0x05,
  chunk = 0x06,
  message_index = 0x07,
  chunk_index = 0x08,
  statistics = 0x0B,
  data_end = 0x0F,
};

/// The bytes with which an MCAP file begins and ends.
inline constexpr std::string_view mcap_magic = "\x89MCAP0\r\n";

/// Bytes of a record before its content: the opcode (1) and the length (8).
inline constexpr std::size_t mcap_head_bytes = 9;

/// A record of an MCAP file. The content is a view of the bytes that were parsed.
struct McapRecord {
  McapOp op{};                         ///< opcode
  std::span<const std::byte> content;  ///< refers to the bytes from which it was taken
};

/// Takes a record from the front of the bytes. @throws Error when fewer bytes are left than it states
[[nodiscard]] McapRecord take_mcap_record(RosBytes& bytes, std::string_view source);

/// A channel record: a topic and the encoding of its messages.
struct McapChannel {
  std::uint16_t id = 0;      ///< number that its messages refer to
  std::uint16_t schema = 0;  ///< number of the schema of its messages
  std::string topic;         ///< name of the topic
  std::string encoding;      ///< of its messages: "cdr" (ROS 2), "ros1"
};

/// Parses a channel record. @throws Error when the record ends early; so do all functions below
[[nodiscard]] McapChannel parse_mcap_channel(std::span<const std::byte> content, std::string_view source);

/// A message record. The data are a view of the bytes that were parsed.
struct McapMessage {
  std::uint16_t channel = 0;        ///< number of its channel
  std::uint64_t time_ns = 0;        ///< recording time, nanoseconds
  std::span<const std::byte> data;  ///< serialised message; refers to the parsed bytes
};

/// Parses a message record; its data refer to `content`.
[[nodiscard]] McapMessage parse_mcap_message(std::span<const std::byte> content, std::string_view source);

/// Decompresses the records of a chunk (LZ4, Zstandard or uncompressed).
/// @throws Error also when the compression is unknown, or the checksum does not match
[[nodiscard]] std::vector<std::byte> unpack_mcap_chunk(std::span<const std::byte> content,
                                                       std::string_view source);

/// Decompresses as much of a chunk as is there, of a file that was cut within it. The checksum is not
/// checked.
/// @param content the beginning of a chunk's content
/// @throws Error when the compression is unknown, or not even the lengths are there
[[nodiscard]] std::vector<std::byte> unpack_cut_mcap_chunk(std::span<const std::byte> content,
                                                           std::string_view source);

}  // namespace rva
