// A database of rosbag2 (.db3): messages by topic, from a file of any size.
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstddef>
#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "depth/recording/recording.hpp"

namespace rva {

/// Whether there is a file that begins as SQLite's databases do.
[[nodiscard]] bool is_db3_file(const std::filesystem::path& path);

/// Tables `topics` and `messages` as rosbag2_storage_default_plugins creates them. The file is neither
/// written nor locked, and nothing is written beside it. Const members may be called from several threads.
class Db3File {
 public:
  /// @throws Error when it is no such database, or cannot be read; Interrupted
  explicit Db3File(const std::filesystem::path& path);

  [[nodiscard]] const RecordedTopics& topics() const { return topics_; }

  /// What to call it in an error.
  [[nodiscard]] const std::string& place() const { return place_; }

  /// false: the recorder did not end the file, or it was cut; messages are missing.
  [[nodiscard]] bool whole() const { return whole_; }

  /// A message's bytes, unpacked where Zstandard packs them. @throws Error when the file is damaged there
  [[nodiscard]] std::vector<std::byte> read(const RecordedMessage& message) const;

 private:
  void find_messages();

  std::string place_;
  SQLite::Database database_;
  RecordedTopics topics_;
  bool whole_ = true;
  mutable std::mutex mutex_;  // guards the database
};

}  // namespace rva
