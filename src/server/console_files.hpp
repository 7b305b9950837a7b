// The console's page and what it loads, read once.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace rva {

struct ConsoleFile {
  std::string content_type;
  std::string bytes;
  std::string gzip;        ///< the same compressed; empty where there is none beside it
  bool immutable = false;  ///< its name changes with what it holds
};

/// All files of a folder, by the path in an address ("/assets/main.js"); "/" is index.html. What is not in
/// here cannot be asked for.
class ConsoleFiles {
 public:
  /// @throws Error when there is no index.html, or a file cannot be read
  explicit ConsoleFiles(const std::filesystem::path& folder);

  /// Null where there is none.
  [[nodiscard]] const ConsoleFile* find(const std::string& path) const;

 private:
  std::map<std::string, ConsoleFile> files_;
};

}  // namespace rva
