#include "map/view_folder.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "capture/folder/capture_writer.hpp"
#include "core/durability.hpp"
#include "core/error.hpp"
#include "core/output_folder.hpp"
#include "core/path_text.hpp"
#include "core/remains.hpp"
#include "map/view_capture.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

std::vector<std::string> view_files() {
  std::vector<std::string> files{"000/capture.json"};
  for (const std::string& file : capture_files()) files.push_back("[0-9][0-9][0-9]/" + file);
  return files;
}

bool is_view_number(const std::string& name) {
  return !name.empty() && name.find_first_not_of("0123456789") == std::string::npos;
}

// Whether a path is an incomplete view that a killed program left.
bool is_remains_of_view(const fs::path& path) {
  const std::string name = path.filename();
  return name.size() > 3 && is_view_number(name.substr(0, 3)) && name[3] == '.' && is_name_of_remains(path);
}

std::vector<fs::path> entries(const fs::path& folder) {
  std::vector<fs::path> paths;
  std::error_code failure;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failure))
    paths.push_back(entry.path());
  return paths;
}

bool holds_something(const fs::path& folder) {
  std::error_code ignored;
  if (!fs::exists(fs::symlink_status(folder, ignored))) return false;
  return !fs::is_directory(folder, ignored) || !std::ranges::all_of(entries(folder), is_remains_of_view);
}

void remove_remains(const fs::path& folder) {
  std::error_code ignored;
  for (const fs::path& path : entries(folder)) {
    if (is_remains_of_view(path)) fs::remove_all(path, ignored);
  }
}

void require_number_of_views(const fs::path& folder, std::size_t count) {
  for (const fs::path& path : entries(folder)) {
    const std::string name = path.filename();
    if (is_view_number(name) && (name.size() > 3 || std::stoul(name) >= count))
      throw Error(printable(path), fmt::format("is more than the {} views of these waypoints", count),
                  "resume with the same waypoints, or move it away");
  }
}

// Throws if the folder contains anything but views, as an OutputFolder that would replace it does.
void require_only_views(const fs::path& folder) {
  const OutputFolder replaceable(folder, view_files(), Existing::replace);
}

Error cannot_be_made(const fs::path& path, const std::string& reason) {
  return {printable(path), fmt::format("cannot be created ({})", reason),
          "check the permissions there or choose another location"};
}

}  // namespace

fs::path next_views(const fs::path& views) { return views.native() + ".next"; }

ViewFolder::ViewFolder(fs::path views, Start start, std::size_t count)
    : views_(std::move(views)), path_(views_) {
  require_utf8(views_);
  make_folders(views_);
  lock_ = FolderLock::try_lock(views_);
  if (lock_ == nullptr) {
    if (::access(views_.c_str(), R_OK | X_OK) != 0) throw cannot_be_made(views_, "it may not be read");
    throw Error(printable(views_), "is being filled by another program",
                "wait for it, or choose another name");
  }
  try {
    choose(start);
    make_folders(path_);
    remove_remains(path_);
    require_number_of_views(path_, count);
  } catch (const Error&) {
    remove_empty();
    throw;
  }
}

ViewFolder::~ViewFolder() { remove_empty(); }

void ViewFolder::choose(Start start) {
  const fs::path next = next_views(views_);
  const bool earlier = holds_something(views_);
  const bool begun = holds_something(next);
  if (start == Start::anew && (earlier || begun))
    throw Error(printable(earlier ? views_ : next), "contains the views of a map",
                "resume it, overwrite it, or choose another name");
  if (start == Start::resume && begun) path_ = next;
  if (start != Start::replace || !earlier) return;
  remove_remains(views_);
  require_only_views(views_);
  if (begun) {
    remove_remains(next);
    require_only_views(next);
    std::error_code failure;
    fs::remove_all(next, failure);
    if (failure) throw cannot_be_made(next, failure.message());
  }
  path_ = next;
}

// rmdir() fails for a folder that is not empty, as intended.
void ViewFolder::remove_empty() const {
  ::rmdir(next_views(views_).c_str());
  ::rmdir(views_.c_str());
}

}  // namespace rva
