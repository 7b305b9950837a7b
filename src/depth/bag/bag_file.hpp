// A ROS bag of version 2.0: messages by topic, from a file of any size.
#pragma once

#include <cstddef>
#include <cstdint>
#include <deque>
#include <filesystem>
#include <memory>
#include <mutex>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/file.hpp"
#include "depth/bag/bag_index.hpp"

namespace rva {

/// Memory holds where messages are, and the few chunks that were read last. Const members may be called from
/// several threads.
class BagFile {
 public:
  /// @throws Error as read_bag_index(), or when the file cannot be read; Interrupted
  explicit BagFile(const std::filesystem::path& path);

  [[nodiscard]] const BagIndex& index() const { return index_; }

  /// What to call it in an error.
  [[nodiscard]] const std::string& place() const { return place_; }

  /// A message's bytes. @throws Error when the file is damaged there
  [[nodiscard]] std::vector<std::byte> read(const RecordedMessage& message) const;

 private:
  using Chunk = std::shared_ptr<const std::vector<std::byte>>;

  [[nodiscard]] Chunk chunk(std::uint64_t at) const;

  OpenFile file_;
  std::string place_;
  BagIndex index_;
  mutable std::mutex mutex_;  // guards the next
  mutable std::deque<std::pair<std::uint64_t, Chunk>> recent_chunks_;
};

}  // namespace rva
