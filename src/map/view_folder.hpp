// The folder of a map's captures while the map is being made.
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>

#include "core/folder_lock.hpp"

namespace rva {

/// Locks the folder of a map's captures and selects where to take them. Captures of an earlier map stay in
/// VIEWS while the new ones are taken beside them, in VIEWS.next. Meanwhile no other program can use either
/// folder. The destructor keeps the captures, so that a later run can resume, and removes empty folders.
class ViewFolder {
 public:
  /// What happens with the views of an earlier map.
  enum class Start {
    anew,     ///< refuses folders that contain views
    resume,   ///< adds to the existing views; to those in VIEWS.next, if any
    replace,  ///< begins VIEWS.next if VIEWS contains an earlier map's views and nothing else
  };

  /// Also removes incomplete views that killed programs left.
  /// @param count number of views of the map
  /// @throws Error when the folder is in use, has contents that `start` does not allow or further views, or
  ///         cannot be created
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
  std::unique_ptr<FolderLock> lock_;  // on views_; protects both folders
};

/// The path VIEWS.next.
[[nodiscard]] std::filesystem::path next_views(const std::filesystem::path& views);

}  // namespace rva
