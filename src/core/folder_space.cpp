#include "core/folder_space.hpp"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <system_error>

#include "core/error.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

// The error of writing one byte into a file without a name, which the system removes by itself; 0 for none.
int failure_of_writing(const std::filesystem::path& folder) {
  const int file = open(folder.c_str(), O_TMPFILE | O_WRONLY | O_CLOEXEC, 0600);
  if (file < 0) return errno;
  const int failure = write(file, "", 1) == 1 ? 0 : errno;
  close(file);
  return failure;
}

bool lacks_unnamed_files(int failure) { return failure == EOPNOTSUPP || failure == EISDIR; }

}  // namespace

FolderSpace space_of(const std::filesystem::path& folder) {
  std::error_code failure;
  const std::filesystem::space_info space = std::filesystem::space(folder, failure);
  if (failure)
    throw Error(printable(folder), "the free space cannot be determined (" + failure.message() + ")",
                "check that the folder exists");
  return {space.available, space.capacity};
}

void require_writable(const std::filesystem::path& folder) {
  int failure = failure_of_writing(folder);
  // Some file systems have no files without a name: permissions are then all that can be checked.
  if (lacks_unnamed_files(failure)) failure = access(folder.c_str(), W_OK | X_OK) == 0 ? 0 : errno;
  if (failure == 0) return;
  throw Error(printable(folder),
              "no file can be written here (" + std::generic_category().message(failure) + ")",
              "check its owner, its permissions and its disk");
}

}  // namespace rva
