// A ROS bag of version 2.0: messages by topic, from a file of any size.
#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <string>
#include <vector>

#include "capture/recording/recent_chunks.hpp"
#include "capture/rosbag1/bag_index.hpp"
#include "core/file.hpp"

namespace rva {

/// Keeps the positions of messages and the few chunks that were read last in memory. Const members may be
/// called from several threads.
class BagFile {
 public:
  /// @throws Error as read_bag_index(), or when the file cannot be read; Interrupted
  explicit BagFile(const std::filesystem::path& path);

  /// The topics, and whether the file is complete.
  [[nodiscard]] const BagIndex& index() const { return index_; }

  /// The file's name, for errors.
  [[nodiscard]] const std::string& source() const { return source_; }

  /// Reads a message's bytes. @throws Error when the file is damaged there
  [[nodiscard]] std::vector<std::byte> read(const RecordedMessage& message) const;

 private:
  OpenFile file_;
  std::string source_;
  BagIndex index_;
  mutable RecentChunks chunks_;
};

}  // namespace rva
