// Where the messages of a ROS bag lie.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/file.hpp"
#include "depth/bag/bag_record.hpp"
#include "depth/recording/recording.hpp"

namespace rva {

/// A record on the disk: its header, and where its data is.
struct BagRecordPlace {
  std::vector<std::byte> fields;  ///< what the texts of `header` lie in
  BagRecordHeader header;
  std::uint64_t data_at = 0;
  std::uint32_t data_bytes = 0;

  [[nodiscard]] std::uint64_t end() const { return data_at + data_bytes; }
};

/// The record at this byte; its data is not read.
/// @throws Error when there is no whole header of a record there
[[nodiscard]] BagRecordPlace find_record(const OpenFile& file, std::uint64_t at, const std::string& place);

/// The records of the chunk at this byte. @throws Error when there is none, or it is damaged
[[nodiscard]] std::vector<std::byte> read_chunk(const OpenFile& file, std::uint64_t at,
                                                const std::string& place);

struct BagIndex {
  RecordedTopics topics;
  bool finished = true;            ///< false: the recorder did not end the file, or it was cut
  std::size_t damaged_chunks = 0;  ///< left out; only looked for where the file is not finished
};

/// Reads the index that the recorder left at the end. Where there is none, or it is damaged, every chunk is
/// unpacked once and forgotten, and what stands in whole chunks is found.
/// @throws Error when the file is no bag of version 2.0; Interrupted
[[nodiscard]] BagIndex read_bag_index(const OpenFile& file, const std::string& place);

}  // namespace rva
