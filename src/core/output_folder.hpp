// Results appear whole or not at all.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/remains.hpp"

namespace rva {

/// What to do when the target of an OutputFolder is there already.
enum class Existing {
  refuse,   ///< throw, unless it is an empty folder
  replace,  ///< take its place at commit(), if it holds an earlier result of the same kind and nothing else
};

/// What to do with an incomplete result that a killed program left beside the target (TARGET.partial-...).
enum class Remains {
  remove,  ///< unless it holds anything that is no part of such a result
  keep,    ///< what a device saw cannot be seen again
};

/// Whether a folder holds nothing but what such a result may hold (see OutputFolder), complete or not.
[[nodiscard]] bool holds_only(const std::filesystem::path& folder, const std::vector<std::string>& files);

/// A folder that is written beside its target, under a name of its own, and renamed when complete: whatever
/// stops the program, the target is there whole, or as it was, and stays so through a power cut. Destroyed
/// without commit(), it leaves nothing behind, nor parents that it made. Not for use by several threads.
class OutputFolder {
 public:
  /// @param target  the folder to appear at commit(); its parents are made
  /// @param files   what such a result may hold, the first of them always: paths inside it, in which * and
  ///                [0-9] stand for parts of a name as in a shell ("depth/*.png"). A folder that lacks the
  ///                first, or holds anything else at any depth, is never replaced
  /// @throws Error  the target exists (see Existing), is not UTF-8, or its parent cannot be written
  OutputFolder(const std::filesystem::path& target, std::vector<std::string> files, Existing existing,
               Remains remains = Remains::remove);
  ~OutputFolder();
  OutputFolder(const OutputFolder&) = delete;
  OutputFolder& operator=(const OutputFolder&) = delete;

  /// Where to write a file of the result until commit(); of subfolders, the caller makes each.
  [[nodiscard]] std::filesystem::path path(const std::filesystem::path& name) const {
    return staging_->path() / name;
  }

  /// Incomplete results beside the target that killed programs left and that were not removed, for a message.
  [[nodiscard]] const std::vector<std::filesystem::path>& remains() const { return remains_; }

  /// Leaves what was written where it is now, beside the target, for a person to see to.
  /// @return its path
  std::filesystem::path keep_partial();

  /// Puts the folder in its place, and looks again whether it may. @throws Error and leaves the target as it
  /// was.
  void commit();

 private:
  void remove_made_parents() const;

  std::filesystem::path target_;
  std::vector<std::string> files_;
  Existing existing_;
  std::vector<std::filesystem::path> remains_;
  std::optional<StagingFolder> staging_;
  std::filesystem::path highest_made_;  // of the target's parents, the first that was not there; may be empty
  bool stays_ = false;
};

}  // namespace rva
