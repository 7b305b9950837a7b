// Results appear whole or not at all.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/error.hpp"
#include "core/remains.hpp"

namespace rva {

/// What to do when the target of an OutputFolder already exists.
enum class Existing {
  refuse,   ///< throw, unless it is an empty folder
  replace,  ///< replace it at commit(), if it contains an earlier result of the same kind and nothing else
};

/// What to do with an incomplete result that a killed program left beside the target (TARGET.partial-...).
enum class Remains {
  remove,  ///< unless it contains anything that is not part of such a result
  keep,    ///< for recordings, which cannot be repeated
};

/// The target of an OutputFolder exists and is not to be replaced.
class ExistsError : public Error {
 public:
  using Error::Error;
};

/// Whether a folder contains nothing but files of a result (see OutputFolder), be it complete or not.
[[nodiscard]] bool holds_only(const std::filesystem::path& folder, const std::vector<std::string>& files);

/// A result folder that is written beside its target, under a temporary name, and renamed when it is
/// complete: whatever stops the program, also a power cut, the target is complete or unchanged. Destroyed
/// without commit() or keep_partial(), it removes what was written and the parent folders that it created.
/// Not for use by several threads.
class OutputFolder {
 public:
  /// @param target  the folder to appear at commit(); missing parents are created at once
  /// @param files   the files that such a result may contain: paths inside it, in which * and [0-9] are
  ///                wildcards as in a shell ("depth/*.png"). Every result contains the first. A folder that
  ///                lacks the first, or contains anything else at any depth, is never replaced
  /// @throws ExistsError when the target exists and is not to be replaced
  /// @throws Error  when the target is not replaceable (see Existing) or not UTF-8, or its parent cannot be
  ///                written
  OutputFolder(const std::filesystem::path& target, std::vector<std::string> files, Existing existing,
               Remains remains = Remains::remove);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Where to write a file of the result until commit(). The caller creates subfolders.
  [[nodiscard]] std::filesystem::path path(const std::filesystem::path& name) const {
    return staging_->path() / name;
  }

  /// Incomplete results beside the target that killed programs left and that were not removed, for a message.
  [[nodiscard]] const std::vector<std::filesystem::path>& remains() const { return remains_; }

  /// Leaves what was written where it is now, beside the target, for the user to decide about.
  /// @return its path
  std::filesystem::path keep_partial();

  /// Checks again that the target may be written, and renames the folder to it.
  /// @throws Error when it may not be written, or the system refuses; the target is then unchanged
  void commit();

 private:
  void remove_made_parents() const;

  std::filesystem::path target_;
  std::vector<std::string> files_;
  Existing existing_;
  std::vector<std::filesystem::path> remains_;
  std::optional<StagingFolder> staging_;
  std::filesystem::path highest_made_;  // topmost parent of the target that did not exist; may be empty
  bool stays_ = false;
};

}  // namespace rva
