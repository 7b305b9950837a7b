// Finds the messages of an MCAP file.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "capture/recording/recording.hpp"
#include "core/file.hpp"

namespace rva {

/// The topics of an MCAP recording and the positions of their messages.
struct McapIndex {
  RecordedTopics topics;                                      ///< the messages by topic
  std::map<std::string, std::string, std::less<>> encodings;  ///< of messages, by topic: "cdr", "ros1"
  bool finished = true;            ///< false: the recorder did not finish the file, or it was truncated
  std::size_t damaged_chunks = 0;  ///< chunks left out
};

/// Reads the record at byte `at`, including its head. @throws Error when the file ends before the record does
[[nodiscard]] std::vector<std::byte> read_mcap_record(const OpenFile& file, std::uint64_t at,
                                                      const std::string& source);

/// The records of the chunk at byte `at`, or the single record there that is outside chunks. Of a chunk that
/// the end of the file cuts, those that are there. @throws Error when it is damaged
[[nodiscard]] std::vector<std::byte> read_mcap_records(const OpenFile& file, std::uint64_t at,
                                                       const std::string& source);

/// Reads the index that the recorder wrote at the end. Where there is none, or it is damaged, all records are
/// read, and every chunk is decompressed once.
/// @throws Error when the file is not an MCAP file; Interrupted
[[nodiscard]] McapIndex read_mcap_index(const OpenFile& file, const std::string& source);

}  // namespace rva
