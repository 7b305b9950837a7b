// One program at a time in a folder.
#pragma once

#include <filesystem>

namespace rva {

/// Held while it lives, and let go by the system if the program dies.
class FolderLock {
 public:
  /// @param folder exists
  /// @throws Error when another program holds it, or it cannot be opened
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

 private:
  int descriptor_;
};

}  // namespace rva
