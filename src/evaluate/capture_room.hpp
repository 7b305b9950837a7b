// Temporary storage for the captures of one inspection.
#pragma once

#include <filesystem>

namespace rva {

/// A folder for temporary files, removed with its contents when the object is destroyed.
class CaptureRoom {
 public:
  /// @throws Error if the folder cannot be created
  CaptureRoom();
  ~CaptureRoom();
  CaptureRoom(const CaptureRoom&) = delete;
  CaptureRoom& operator=(const CaptureRoom&) = delete;

  /// The folder's path.
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace rva
