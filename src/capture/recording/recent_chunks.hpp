// A cache of decompressed chunks of a recording.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <utility>
#include <vector>

namespace rva {

/// Keeps the chunks that were decompressed last. May be used by several threads at once.
class RecentChunks {
 public:
  /// A decompressed chunk. It stays valid while it is used, also when the cache drops it.
  using Chunk = std::shared_ptr<const std::vector<std::byte>>;

  /// The chunk at a position, from the cache or unpacked.
  /// @param at     the chunk's position in the file
  /// @param unpack returns its bytes; called when they are not in the cache. What it throws is passed on
  [[nodiscard]] Chunk get(std::uint64_t at, auto&& unpack) {
    {
      const std::lock_guard lock(mutex_);
      const auto known = std::ranges::find(chunks_, at, &std::pair<std::uint64_t, Chunk>::first);
      if (known != chunks_.end()) return known->second;
    }
    auto unpacked = std::make_shared<const std::vector<std::byte>>(unpack());
    const std::lock_guard lock(mutex_);
    chunks_.emplace_front(at, unpacked);
    if (chunks_.size() > most_chunks) chunks_.pop_back();
    return unpacked;
  }

 private:
  // A frame, its metadata and its neighbours are in one or two chunks.
  static constexpr std::size_t most_chunks = 8;

  std::mutex mutex_;  // guards the next
  std::deque<std::pair<std::uint64_t, Chunk>> chunks_;
};

}  // namespace rva
