// Temporary folders and files in which results are written, and what killed programs leave of them.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "core/folder_lock.hpp"

namespace rva {

/// Creates a folder beside `target` with a unique name (TARGET.partial-PID-N). The folder is locked for the
/// lifetime of this object, so that other programs can distinguish it from one that a killed program left.
/// The destructor does not remove it.
class StagingFolder {
 public:
  /// @throws Error when it cannot be created
  explicit StagingFolder(const std::filesystem::path& target);

  /// The folder, whose name is unique.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::unique_ptr<FolderLock> lock_;
};

/// Restores an earlier result that a killed program had moved aside without putting the new one in place, and
/// removes folders and files beside `target` that such a program had not completed.
/// @param may_remove whether a path contains nothing worth keeping; other paths are kept
/// @return the paths that are kept
std::vector<std::filesystem::path> recover_remains(
    const std::filesystem::path& target, const std::function<bool(const std::filesystem::path&)>& may_remove);

/// Whether a name is that of a StagingFolder, or of a temporary file of replace_file(), for any target.
[[nodiscard]] bool is_name_of_remains(const std::filesystem::path& name);

}  // namespace rva
