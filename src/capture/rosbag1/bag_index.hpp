// Finds the messages of a ROS bag.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "capture/recording/recording.hpp"
#include "capture/rosbag1/bag_record.hpp"
#include "core/file.hpp"

namespace rva {

/// A record in the file: its header, and the position of its data.
struct BagRecordLocation {
  std::vector<std::byte> fields;  ///< storage of the texts of `header`
  BagRecordHeader header;         ///< parsed; its texts refer to `fields`
  std::uint64_t data_at = 0;      ///< byte of the file where its data begin
  std::uint32_t data_bytes = 0;   ///< number of bytes of its data

  /// Byte of the file after the record, where the next one begins.
  [[nodiscard]] std::uint64_t end() const { return data_at + data_bytes; }
};

/// Reads the header of the record at byte `at` of the file; its data is not read.
/// @param source the file's name, for errors, here and below
/// @throws Error when there is no complete header there
[[nodiscard]] BagRecordLocation find_record(const OpenFile& file, std::uint64_t at,
                                            const std::string& source);

/// Reads and decompresses the records of the chunk at byte `at`. @throws Error when there is none, or it
/// is damaged
[[nodiscard]] std::vector<std::byte> read_chunk(const OpenFile& file, std::uint64_t at,
                                                const std::string& source);

/// The topics of a ROS 1 recording and the positions of their messages.
struct BagIndex {
  RecordedTopics topics;           ///< the messages by topic
  bool finished = true;            ///< false: the recorder did not finish the file, or it was truncated
  std::size_t damaged_chunks = 0;  ///< chunks left out; always 0 where the index was read
};

/// Reads the index that the recorder wrote at the end. Where there is none, or it is damaged, every chunk is
/// decompressed once to find the messages in complete chunks.
/// @throws Error when the file is no bag of version 2.0; Interrupted
[[nodiscard]] BagIndex read_bag_index(const OpenFile& file, const std::string& source);

}  // namespace rva
