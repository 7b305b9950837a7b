// Where the messages of an MCAP file lie.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "core/file.hpp"
#include "depth/recording/recording.hpp"

namespace rva {

struct McapIndex {
  RecordedTopics topics;
  std::map<std::string, std::string, std::less<>> encodings;  ///< of messages, by topic: "cdr", "ros1"
  bool finished = true;            ///< false: the recorder did not end the file, or it was cut
  std::size_t damaged_chunks = 0;  ///< left out
};

/// The whole record at this byte, its head included. @throws Error when the file ends before it does
[[nodiscard]] std::vector<std::byte> read_mcap_record(const OpenFile& file, std::uint64_t at,
                                                      const std::string& place);

/// Reads the index that the recorder left at the end. Where there is none, all records are gone through, and
/// every chunk is unpacked once and forgotten.
/// @throws Error when the file is no MCAP file; Interrupted
[[nodiscard]] McapIndex read_mcap_index(const OpenFile& file, const std::string& place);

}  // namespace rva
