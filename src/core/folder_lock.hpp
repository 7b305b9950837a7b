// A lock by which only one program at a time uses a folder.
#pragma once

#include <filesystem>
#include <memory>

namespace rva {

/// Locks a folder for the lifetime of the object. The system releases the lock if the program dies.
class FolderLock {
 public:
  /// @param folder must exist
  /// @throws Error when another program has locked it, or it cannot be opened
  explicit FolderLock(const std::filesystem::path& folder);
  ~FolderLock();
  FolderLock(const FolderLock&) = delete;
  FolderLock& operator=(const FolderLock&) = delete;

  /// Locks a folder without waiting.
  /// @return null when another program has locked it, it cannot be opened, or it has been removed meanwhile
  [[nodiscard]] static std::unique_ptr<FolderLock> try_lock(const std::filesystem::path& folder);

 private:
  explicit FolderLock(int descriptor) : descriptor_(descriptor) {}

  int descriptor_;
};

}  // namespace rva
