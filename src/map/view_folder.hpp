// The folder of a map's captures while a map is being made.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>

#include "core/folder_lock.hpp"

namespace rva {

/// Captures of an earlier map stay where they are while those that shall replace them are taken beside them,
/// in VIEWS.next. Nobody else can fill either folder meanwhile. Destroyed, it leaves what was taken, for
/// whoever resumes; an empty folder goes.
class ViewFolder {
 public:
  enum class Start {
    anew,     ///< refuses folders that hold views
    resume,   ///< goes on with the views that are there; with VIEWS.next where there is one
    replace,  ///< begins VIEWS.next where VIEWS holds an earlier map's views and nothing else
  };

  /// @param count how many views there will be; removes what is left of views whose program was killed
  /// @throws Error the folder is in use, holds what it must not (see Start) or more views, or cannot be made
  ViewFolder(std::filesystem::path views, Start start, std::size_t count);
  ~ViewFolder();
  ViewFolder(const ViewFolder&) = delete;
  ViewFolder& operator=(const ViewFolder&) = delete;

  /// Where the captures are to be taken.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  void choose(Start start);
  void remove_empty() const;

  std::filesystem::path views_;
  std::filesystem::path path_;
  std::unique_ptr<FolderLock> lock_;  // of `views_`, for both
};

/// VIEWS.next
[[nodiscard]] std::filesystem::path next_views(const std::filesystem::path& views);

}  // namespace rva
