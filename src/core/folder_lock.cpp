#include "core/folder_lock.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "core/error.hpp"
#include "core/path_text.hpp"

namespace rva {

FolderLock::FolderLock(const std::filesystem::path& folder)
    : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
  if (descriptor_ < 0)
    throw Error(printable(folder),
                fmt::format("cannot be opened ({})", std::generic_category().message(errno)),
                "give a folder that can be written");
  if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) return;
  ::close(descriptor_);
  throw Error(printable(folder), "is used by another rva", "end that one, or give another folder");
}

FolderLock::~FolderLock() { ::close(descriptor_); }

}  // namespace rva
