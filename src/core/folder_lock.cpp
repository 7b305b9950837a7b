#include "core/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <utility>

#include "core/error.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

int open_folder(const std::filesystem::path& folder) {
  return ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
}

bool lock_at_once(int descriptor) { return ::flock(descriptor, LOCK_EX | LOCK_NB) == 0; }

bool is_still(int descriptor, const std::filesystem::path& folder) {
  struct stat held {};
  struct stat named {};
  return ::fstat(descriptor, &held) == 0 && ::stat(folder.c_str(), &named) == 0 &&
         held.st_dev == named.st_dev && held.st_ino == named.st_ino;
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder) : descriptor_(open_folder(folder)) {
  if (descriptor_ < 0)
    throw Error(printable(folder),
                fmt::format("cannot be opened ({})", std::generic_category().message(errno)),
                "give a folder that can be written");
  if (lock_at_once(descriptor_)) return;
  ::close(descriptor_);
  throw Error(printable(folder), "is used by another rva", "stop that one, or choose another folder");
}

std::unique_ptr<FolderLock> FolderLock::try_lock(const std::filesystem::path& folder) {
  const int descriptor = open_folder(folder);
  if (descriptor < 0) return nullptr;
  std::unique_ptr<FolderLock> lock(new FolderLock(descriptor));
  return lock_at_once(descriptor) && is_still(descriptor, folder) ? std::move(lock) : nullptr;
}

FolderLock::~FolderLock() { ::close(descriptor_); }

}  // namespace rva
