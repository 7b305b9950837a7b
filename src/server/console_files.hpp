// The console's page and the files that it loads, read once.
#pragma once

#include <filesystem>
#include <map>
#include <string>

namespace rva {

/// A file of the console as the server sends it.
struct ConsoleFile {
  std::string content_type;
  std::string bytes;
  std::string gzip;        ///< the same compressed; empty if there is no .gz file beside it
  bool immutable = false;  ///< its name changes with its content
};

/// All files of a folder, by the path in a URL ("/assets/main.js"); "/" is index.html. Other files cannot be
/// requested.
class ConsoleFiles {
 public:
  /// @throws Error when there is no index.html, or a file cannot be read
  explicit ConsoleFiles(const std::filesystem::path& folder);

  /// Null if there is no such file.
  [[nodiscard]] const ConsoleFile* find(const std::string& path) const;

 private:
  std::map<std::string, ConsoleFile> files_;
};

}  // namespace rva
