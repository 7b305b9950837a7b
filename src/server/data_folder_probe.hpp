// Whether the data folder can be written, checked at most once in ten seconds.
#pragma once

#include <filesystem>
#include <mutex>
#include <optional>
#include <string>

namespace rva {

/// Remembers the last check, since a check writes to the disk and requests of any client lead to it. The
/// member may be called from any thread.
class DataFolderProbe {
 public:
  /// What is wrong with the folder, for the user; empty if files can be written into it.
  [[nodiscard]] std::string problem(const std::filesystem::path& folder, double now_s);

 private:
  std::mutex mutex_;
  std::optional<double> checked_s_;
  std::string problem_;
};

}  // namespace rva
