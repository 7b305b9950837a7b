#include "map/view_folder.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "core/error.hpp"
#include "core/output_folder.hpp"
#include "core/path_text.hpp"
#include "depth/capture_writer.hpp"
#include "map/view_capture.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

bool holds_something(const fs::path& path) {
  std::error_code failure;
  const bool there = fs::exists(fs::symlink_status(path, failure));
  return there &&
         !(fs::is_directory(fs::symlink_status(path, failure)) && fs::is_empty(path, failure) && !failure);
}

// What an earlier map's folder may hold, views whose program was killed included.
std::vector<std::string> view_files() {
  std::vector<std::string> files{"000/capture.json"};
  for (const char* const folder : {"[0-9][0-9][0-9]/", "[0-9][0-9][0-9].partial-*/"}) {
    for (const std::string& file : capture_files()) files.push_back(folder + file);
  }
  return files;
}

Error cannot_be_made(const fs::path& path, const std::error_code& failure) {
  return {printable(path), fmt::format("cannot be made ({})", failure.message()),
          "check the permissions there or choose another place"};
}

}  // namespace

ViewFolder::ViewFolder(fs::path path, Start start, std::size_t views)
    : path_(std::move(path)), aside_(path_.native() + ".replaced") {
  require_utf8(path_);
  const bool filled = holds_something(path_);
  if (filled && start == Start::anew)
    throw Error(printable(path_), "holds the views of a map",
                "give --resume to go on with it, --overwrite to begin anew, or another name");
  try {
    make_and_lock();
    if (filled && start == Start::replace) {
      set_aside();
      make_and_lock();
    }
    remove_remains(views);
  } catch (const Error&) {
    give_back();
    throw;
  }
}

ViewFolder::~ViewFolder() { give_back(); }

void ViewFolder::make_and_lock() {
  std::error_code failure;
  fs::create_directories(path_, failure);
  if (failure) throw cannot_be_made(path_, failure);
  lock_ = ::open(path_.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  if (lock_ < 0) throw cannot_be_made(path_, std::error_code(errno, std::generic_category()));
  if (::flock(lock_, LOCK_EX | LOCK_NB) == 0) return;
  ::close(lock_);
  lock_ = -1;
  throw Error(printable(path_), "is being filled by another program", "wait for it, or choose another name");
}

void ViewFolder::set_aside() {
  const OutputFolder replaceable(path_, view_files(), Existing::replace);  // throws where it is not
  std::error_code failure;
  if (fs::exists(aside_, failure))
    fs::remove_all(path_, failure);  // of an attempt that came to nothing; the earlier views wait already
  else
    fs::rename(path_, aside_, failure);
  if (failure) throw cannot_be_made(aside_, failure);
  ::close(lock_);
  lock_ = -1;
}

void ViewFolder::remove_remains(std::size_t views) const {
  std::error_code failure;
  std::vector<fs::path> remains;
  for (const fs::directory_entry& entry : fs::directory_iterator(path_, failure)) {
    const std::string name = entry.path().filename();
    const std::size_t digits = name.find_first_not_of("0123456789");
    if (digits == 3 && name.substr(digits).starts_with(".partial-")) remains.push_back(entry.path());
    if (digits == std::string::npos && (name.size() > 3 || std::stoul(name) >= views))
      throw Error(printable(entry.path()), fmt::format("is more than the {} views of these waypoints", views),
                  "resume with the same waypoints, or move it away");
  }
  for (const fs::path& path : remains) fs::remove_all(path, failure);
}

void ViewFolder::give_back() {
  std::error_code ignored;
  if (lock_ >= 0) {
    ::rmdir(path_.c_str());  // fails, as it should, where it is not empty
    ::close(lock_);
    lock_ = -1;
  }
  if (!fs::exists(path_, ignored) && fs::exists(aside_, ignored)) fs::rename(aside_, path_, ignored);
}

void ViewFolder::done() {
  std::error_code ignored;
  fs::remove_all(aside_, ignored);
}

}  // namespace rva
