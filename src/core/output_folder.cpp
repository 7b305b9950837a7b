#include "core/output_folder.hpp"

#include <fmt/format.h>
#include <fnmatch.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "core/durability.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

bool is_empty_folder(const fs::path& path) {
  std::error_code failure;
  return fs::is_directory(fs::symlink_status(path, failure)) && fs::is_empty(path, failure) && !failure;
}

// The folder of a file's path that is as deep in the result as the folder `other`; empty where the file is
// not inside a folder of that depth.
std::string folder_as_deep(const std::string& file, const std::string& other) {
  std::size_t end = 0;
  for (auto slashes = std::ranges::count(other, '/') + 1; slashes > 0; --slashes) {
    end = file.find('/', end == 0 ? 0 : end + 1);
    if (end == std::string::npos) return {};
  }
  return file.substr(0, end);
}

bool is_part(const fs::directory_entry& entry, const fs::path& target,
             const std::vector<std::string>& files) {
  const std::string name = entry.path().lexically_relative(target).native();
  const bool is_folder = entry.symlink_status().type() == fs::file_type::directory;
  return std::ranges::any_of(files, [&](const std::string& file) {
    const std::string pattern = is_folder ? folder_as_deep(file, name) : file;
    return ::fnmatch(pattern.c_str(), name.c_str(), FNM_PATHNAME | FNM_PERIOD) == 0;
  });
}

void require_replaceable(const fs::path& target, const std::vector<std::string>& files) {
  std::error_code ignored;
  if (!fs::is_directory(fs::symlink_status(target, ignored)) ||
      !fs::exists(target / files.front(), ignored)) {
    throw Error(printable(target),
                fmt::format("contains no earlier result (no {}), so it is not replaced", files.front()),
                "choose another folder");
  }
  try {
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(target)) {
      if (is_part(entry, target, files)) continue;
      throw Error(printable(entry.path()), "is not part of an earlier result, so the folder is not replaced",
                  "move it away or choose another folder");
    }
  } catch (const fs::filesystem_error& error) {
    throw Error(printable(target), fmt::format("cannot be read ({})", error.code().message()),
                "check its permissions or choose another folder");
  }
}

void require_free_target(const fs::path& target, const std::vector<std::string>& files, Existing existing) {
  std::error_code ignored;
  if (!fs::exists(fs::symlink_status(target, ignored)) || is_empty_folder(target)) return;
  if (existing == Existing::refuse) {
    throw ExistsError(printable(target), "already exists",
                      "choose another folder, or overwrite the earlier result");
  }
  require_replaceable(target, files);
}

// The topmost of a folder and its parents that does not exist; empty where all exist.
fs::path highest_missing(fs::path folder) {
  std::error_code ignored;
  fs::path highest;
  for (; !fs::exists(folder, ignored) && folder.has_relative_path(); folder = folder.parent_path())
    highest = folder;
  return highest;
}

void sync_made_folders(const fs::path& from, const fs::path& highest) {
  if (highest.empty()) return;
  for (fs::path folder = from; folder != highest.parent_path(); folder = folder.parent_path())
    sync_folder(folder.parent_path());
}

}  // namespace

bool holds_only(const fs::path& folder, const std::vector<std::string>& files) {
  std::error_code failure;
  if (!fs::is_directory(fs::symlink_status(folder, failure))) return false;
  for (fs::recursive_directory_iterator entry(folder, failure), end; !failure && entry != end;
       entry.increment(failure)) {
    const bool under_way = entry->is_regular_file(failure) && is_name_of_remains(entry->path());
    if (!under_way && !is_part(*entry, folder, files)) return false;
  }
  return !failure;
}

OutputFolder::OutputFolder(const fs::path& target, std::vector<std::string> files, Existing existing,
                           Remains remains)
    : files_(std::move(files)), existing_(existing) {
  if (target.empty()) throw Error(printable(target), "no folder was given for the result", "give one");
  require_utf8(target);
  std::error_code failure;
  target_ = fs::absolute(target, failure).lexically_normal();
  if (!target_.has_filename()) target_ = target_.parent_path();  // "OUT/" means OUT
  remains_ = recover_remains(target_, [&](const fs::path& folder) {
    return remains == Remains::remove && holds_only(folder, files_);
  });
  require_free_target(target_, files_, existing_);
  highest_made_ = highest_missing(target_.parent_path());
  fs::create_directories(target_.parent_path(), failure);
  if (failure) {
    remove_made_parents();
    throw Error(printable(target_.parent_path()), fmt::format("cannot be created ({})", failure.message()),
                "check the permissions there or choose another location");
  }
  try {
    staging_.emplace(target_);
  } catch (const Error&) {
    remove_made_parents();
    throw;
  }
}

OutputFolder::~OutputFolder() {
  if (stays_) return;
  std::error_code ignored;
  fs::remove_all(staging_->path(), ignored);
  remove_made_parents();
}

// Removes empty folders only: one that another program has begun to use stays, with all of its parents.
void OutputFolder::remove_made_parents() const {
  if (highest_made_.empty()) return;
  std::error_code failure;
  for (fs::path parent = target_.parent_path();; parent = parent.parent_path()) {
    if (!fs::remove(parent, failure) || parent == highest_made_) return;
  }
}

fs::path OutputFolder::keep_partial() {
  stays_ = true;
  return staging_->path();
}

void OutputFolder::commit() {
  require_free_target(target_, files_, existing_);
  sync_tree(staging_->path());
  sync_made_folders(target_.parent_path(), highest_made_);
  std::error_code ignored;
  if (!fs::exists(target_, ignored) || is_empty_folder(target_)) {
    move_into_place(staging_->path(), target_);
    stays_ = true;
    return;
  }
  exchange(staging_->path(), target_);
  stays_ = true;
  // The staging folder now has the earlier result. It stays if other files have been put there meanwhile.
  if (holds_only(staging_->path(), files_)) fs::remove_all(staging_->path(), ignored);
}

}  // namespace rva
