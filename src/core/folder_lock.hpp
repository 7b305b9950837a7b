// One program at a time in a folder.
#pragma once

#include <filesystem>
#include <memory>

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

  /// @return null when another program holds it, it cannot be opened, or it has been removed in the meantime
  [[nodiscard]] static std::unique_ptr<FolderLock> try_lock(const std::filesystem::path& folder);

 private:
  explicit FolderLock(int descriptor) : descriptor_(descriptor) {}

  int descriptor_;
};

}  // namespace rva
