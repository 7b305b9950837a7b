// Where results are written until they are complete, and what a killed program leaves there.
#pragma once

#include <filesystem>
#include <functional>
#include <memory>
#include <vector>

#include "core/folder_lock.hpp"

namespace rva {

/// A folder beside `target`, with a name that nobody else has (TARGET.partial-PID-N). It is locked while this
/// object lives, so that others can tell it from one that a killed program left. The folder itself stays.
class StagingFolder {
 public:
  /// @throws Error when it cannot be made
  explicit StagingFolder(const std::filesystem::path& target);

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
  std::unique_ptr<FolderLock> lock_;
};

/// Restores an earlier result that a killed program had moved aside without putting the new one in place, and
/// removes folders and files beside `target` that such a program had not completed.
/// @param may_remove whether a path holds nothing that somebody would keep; other paths stay
/// @return the paths that stay
std::vector<std::filesystem::path> recover_remains(
    const std::filesystem::path& target, const std::function<bool(const std::filesystem::path&)>& may_remove);

/// Whether a name is one of a StagingFolder, or of a file under way, for any target.
[[nodiscard]] bool is_name_of_remains(const std::filesystem::path& name);

}  // namespace rva
