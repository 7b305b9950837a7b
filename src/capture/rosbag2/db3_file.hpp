// A database of rosbag2 (.db3): messages by topic, from a file of any size.
#pragma once

#include <SQLiteCpp/Database.h>

#include <cstddef>
#include <filesystem>
#include <mutex>
#include <string>
#include <vector>

#include "capture/recording/recording.hpp"

namespace rva {

/// Whether a regular file begins as SQLite databases do.
[[nodiscard]] bool is_db3_file(const std::filesystem::path& path);

/// Reads the tables `topics` and `messages` as rosbag2_storage_default_plugins creates them. The file is
/// neither written nor locked. Nothing is written beside it, except SQLite's index of a write-ahead log that
/// a killed recorder left. Const members may be called from several threads.
class Db3File {
 public:
  /// @throws Error when it is not such a database, or cannot be read; Interrupted
  explicit Db3File(const std::filesystem::path& path);

  /// The messages by topic.
  [[nodiscard]] const RecordedTopics& topics() const { return topics_; }

  /// The file's name, for errors.
  [[nodiscard]] const std::string& source() const { return source_; }

  /// False when the recorder did not finish the file, or it was truncated: messages may be missing.
  [[nodiscard]] bool whole() const { return whole_; }

  /// Reads a message's bytes and decompresses them if needed. @throws Error when the file is damaged there
  [[nodiscard]] std::vector<std::byte> read(const RecordedMessage& message) const;

 private:
  void find_messages();

  std::string source_;
  SQLite::Database database_;
  RecordedTopics topics_;
  bool whole_ = true;
  mutable std::mutex mutex_;  // guards the database
};

}  // namespace rva
