// The folder of a map's captures while a map is being made.
#pragma once

#include <cstddef>
#include <filesystem>

namespace rva {

/// Nobody else can fill the folder meanwhile. Destroyed before done(), it leaves what was taken, for whoever
/// resumes; where nothing was, an empty folder goes, and earlier views that were to be replaced come back.
class ViewFolder {
 public:
  enum class Start {
    anew,     ///< refuses a folder that holds anything
    resume,   ///< goes on with the views that are there
    replace,  ///< sets an earlier map's views aside, if there is nothing else in the folder
  };

  /// @param views how many there will be; removes what is left of views whose program was killed
  /// @throws Error the folder is in use, holds what it must not (see Start) or more views, or cannot be made
  ViewFolder(std::filesystem::path path, Start start, std::size_t views);
  ~ViewFolder();
  ViewFolder(const ViewFolder&) = delete;
  ViewFolder& operator=(const ViewFolder&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

  /// The new map is in its place: earlier views that were set aside go.
  void done();

 private:
  void make_and_lock();
  void set_aside();
  void remove_remains(std::size_t views) const;
  void give_back();

  std::filesystem::path path_;
  std::filesystem::path aside_;  // where earlier views wait
  int lock_ = -1;
};

}  // namespace rva
