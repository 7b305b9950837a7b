// Writes MCAP files (mcap.dev/spec, version 0): chunks compressed by Zstandard, with an index at the end.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace rva {

/// Writes messages as they come. Whatever stops the program, the chunks written until then can be read.
class McapWriter {
 public:
  /// Creates the file. @param profile what its messages are, "ros2" @throws Error when it cannot be created
  McapWriter(const std::filesystem::path& file, std::string_view profile);
  /// Closes the file; without finish(), it has no index.
  ~McapWriter();
  McapWriter(const McapWriter&) = delete;
  McapWriter& operator=(const McapWriter&) = delete;

  /// The number of a schema or of a channel in the file.
  using Id = std::uint16_t;

  /// @param encoding of the definition: "ros2msg", "jsonschema"
  [[nodiscard]] Id add_schema(std::string_view name, std::string_view encoding, std::string_view definition);
  /// @param encoding of its messages: "cdr", "json"
  [[nodiscard]] Id add_channel(Id schema, std::string_view topic, std::string_view encoding);

  /// @throws Error when the disk is full or refuses
  void write(Id channel, std::uint64_t time_ns, std::span<const std::byte> message);

  /// Writes the index and returns when the file is on the disk. @throws Error as write()
  void finish();

 private:
  using Bytes = std::vector<std::byte>;

  struct Channel {
    Bytes record;
    std::uint64_t messages = 0;
    std::uint32_t next = 0;  ///< sequence number of the next message
  };
  struct ChunkLocation {
    std::uint64_t first_ns = 0;
    std::uint64_t last_ns = 0;
    std::uint64_t at = 0;
    std::uint64_t bytes = 0;
    std::map<Id, std::uint64_t> indices_at;
    std::uint64_t index_bytes = 0;
    std::uint64_t packed_bytes = 0;
    std::uint64_t unpacked_bytes = 0;
  };

  void put(std::span<const std::byte> bytes);
  void add_to_chunk(Id channel, std::uint64_t time_ns, std::span<const std::byte> message);
  void write_chunk();
  [[nodiscard]] Bytes summary() const;
  [[nodiscard]] Bytes statistics() const;

  std::filesystem::path path_;
  int descriptor_;
  std::uint64_t written_bytes_ = 0;
  std::vector<Bytes> schemas_;     // records; the id is the index plus 1
  std::vector<Channel> channels_;  // the id is the index
  std::vector<ChunkLocation> chunks_;

  // The chunk in progress.
  Bytes chunk_;
  ChunkLocation range_;
  std::map<Id, Bytes> indices_;
};

}  // namespace rva
