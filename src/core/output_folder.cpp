#include "core/output_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <system_error>

#include "core/error.hpp"
#include "core/path_text.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

void require_free_target(const fs::path& target, const fs::path& marker, Existing existing) {
  std::error_code ignored;
  const fs::file_status status = fs::symlink_status(target, ignored);
  if (!fs::exists(status)) return;
  const bool folder = fs::is_directory(status);
  if (folder && fs::is_empty(target, ignored)) return;
  if (existing == Existing::refuse) {
    throw Error(printable(target), "is there already",
                "choose another folder, or give --overwrite to replace an earlier result");
  }
  if (!folder || !fs::exists(target / marker, ignored)) {
    throw Error(printable(target),
                fmt::format("holds no earlier result (no {}), so it is not replaced", marker.native()),
                "choose another folder");
  }
}

// Of a folder and its parents, the highest that does not exist; empty where all do.
fs::path highest_missing(fs::path folder) {
  std::error_code ignored;
  fs::path highest;
  for (; !fs::exists(folder, ignored) && folder.has_relative_path(); folder = folder.parent_path())
    highest = folder;
  return highest;
}

// A folder beside `target` under a name that nobody else has.
fs::path make_beside(const fs::path& target) {
  std::error_code failure;
  for (int attempt = 0;; ++attempt) {
    fs::path name = target.native() + fmt::format(".partial-{}-{}", ::getpid(), attempt);
    if (fs::create_directory(name, failure)) return name;
    if (failure) {
      throw Error(printable(target), fmt::format("cannot be made ({})", failure.message()),
                  "check the permissions and the free space there, or choose another place");
    }
  }
}

}  // namespace

OutputFolder::OutputFolder(const fs::path& target, const fs::path& marker, Existing existing) {
  if (target.empty()) throw Error(printable(target), "no folder for the result", "name one");
  require_utf8(target);
  std::error_code failure;
  target_ = fs::absolute(target, failure).lexically_normal();
  if (!target_.has_filename()) target_ = target_.parent_path();  // "OUT/" means OUT
  require_free_target(target_, marker, existing);
  highest_made_ = highest_missing(target_.parent_path());
  fs::create_directories(target_.parent_path(), failure);
  if (failure) {
    remove_made_parents();
    throw Error(printable(target_.parent_path()), fmt::format("cannot be made ({})", failure.message()),
                "check the permissions there or choose another place");
  }
  try {
    staging_ = make_beside(target_);
  } catch (const Error&) {
    remove_made_parents();
    throw;
  }
}

OutputFolder::~OutputFolder() {
  if (committed_) return;
  std::error_code ignored;
  fs::remove_all(staging_, ignored);
  remove_made_parents();
}

// Only empty folders go; one that somebody else has begun to use stays, with all above it.
void OutputFolder::remove_made_parents() const {
  if (highest_made_.empty()) return;
  std::error_code failure;
  for (fs::path parent = target_.parent_path();; parent = parent.parent_path()) {
    if (!fs::remove(parent, failure) || parent == highest_made_) return;
  }
}

void OutputFolder::commit() {
  std::error_code failure;
  std::error_code ignored;
  if (fs::is_directory(target_, ignored) && !fs::is_empty(target_, ignored)) {
    // An earlier result steps aside first, and comes back if the new one cannot take its place.
    const fs::path aside = staging_.native() + "-replaced";
    fs::rename(target_, aside, failure);
    if (!failure) {
      fs::rename(staging_, target_, failure);
      if (failure) {
        fs::rename(aside, target_, ignored);
      } else {
        fs::remove_all(aside, ignored);
      }
    }
  } else {
    fs::rename(staging_, target_, failure);
  }
  if (failure) {
    throw Error(printable(target_), fmt::format("cannot be put in place ({})", failure.message()),
                "check the permissions there or choose another place");
  }
  committed_ = true;
}

}  // namespace rva
