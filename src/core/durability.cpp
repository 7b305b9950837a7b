#include "core/durability.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <stdio.h>  // renameat2()
#include <unistd.h>

#include <cerrno>
#include <system_error>
#include <vector>

#include "core/error.hpp"
#include "core/path_text.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

void sync(const fs::path& path, int kind) {
  const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NOFOLLOW | kind);
  const bool opened = descriptor >= 0;
  const bool synced = opened && ::fsync(descriptor) == 0;
  const int failure = errno;
  if (opened) ::close(descriptor);
  // EINVAL: the file system cannot sync folders.
  if (synced || (opened && failure == EINVAL)) return;
  throw Error(printable(path),
              fmt::format("cannot be flushed to the disk ({})", std::generic_category().message(failure)),
              "check the disk and the permissions there");
}

Error cannot_be_placed(const fs::path& target, const std::error_code& failure) {
  return {printable(target), fmt::format("cannot be moved into place ({})", failure.message()),
          "check the permissions there or choose another location"};
}

// For file systems that cannot exchange two names: the earlier folder is moved aside, and moved back if the
// new one cannot be renamed. A program that is killed in between leaves the earlier folder under a name that
// recover_remains() recognises.
void exchange_in_steps(const fs::path& complete, const fs::path& target) {
  const fs::path aside = complete.native() + "-replaced";
  std::error_code failure;
  std::error_code ignored;
  fs::rename(target, aside, failure);
  if (failure) throw cannot_be_placed(target, failure);
  fs::rename(complete, target, failure);
  fs::rename(aside, failure ? target : complete, ignored);
  if (failure) throw cannot_be_placed(target, failure);
}

}  // namespace

void sync_folder(const fs::path& folder) {
  // A link that the user named as the folder stands for its target.
  std::error_code failure;
  const fs::path real = fs::canonical(folder, failure);
  sync(failure ? folder : real, O_DIRECTORY);
}

void sync_tree(const fs::path& folder) {
  try {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(folder)) {
      const fs::file_type type = entry.symlink_status().type();
      if (type == fs::file_type::regular) sync(entry.path(), 0);
      if (type == fs::file_type::directory) sync(entry.path(), O_DIRECTORY);
    }
  } catch (const fs::filesystem_error& error) {
    throw Error(printable(folder), fmt::format("cannot be read ({})", error.code().message()),
                "check its permissions");
  }
  sync_folder(folder);
}

void make_folders(const fs::path& folder) {
  std::error_code failure;
  std::vector<fs::path> made;
  for (fs::path missing = fs::absolute(folder, failure).lexically_normal();
       !fs::exists(missing, failure) && missing.has_relative_path(); missing = missing.parent_path())
    made.push_back(missing);
  fs::create_directories(folder, failure);
  if (failure)
    throw Error(printable(folder), fmt::format("cannot be created ({})", failure.message()),
                "check the permissions there or choose another location");
  for (const fs::path& one : made) sync_folder(one.parent_path());
}

void move_into_place(const fs::path& complete, const fs::path& target) {
  std::error_code failure;
  fs::rename(complete, target, failure);  // fails, rather than replaces, if the folder is not empty
  if (failure) throw cannot_be_placed(target, failure);
  sync_folder(target.parent_path());
}

void exchange(const fs::path& complete, const fs::path& target) {
  if (::renameat2(AT_FDCWD, complete.c_str(), AT_FDCWD, target.c_str(), RENAME_EXCHANGE) != 0) {
    const int failure = errno;
    if (failure != EINVAL && failure != ENOSYS)
      throw cannot_be_placed(target, std::error_code(failure, std::generic_category()));
    exchange_in_steps(complete, target);
  }
  sync_folder(target.parent_path());
}

}  // namespace rva
