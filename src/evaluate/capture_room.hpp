// Where a study keeps the captures of one inspection.
#pragma once

#include <filesystem>

namespace rva {

/// A folder among the system's temporary ones, gone with all that is in it when this ends.
class CaptureRoom {
 public:
  /// @throws Error when no folder can be made
  CaptureRoom();
  ~CaptureRoom();
  CaptureRoom(const CaptureRoom&) = delete;
  CaptureRoom& operator=(const CaptureRoom&) = delete;

  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace rva
