#include "core/remains.hpp"

#include <fmt/format.h>
#include <signal.h>  // kill()
#include <unistd.h>

#include <cerrno>
#include <regex>
#include <string>
#include <system_error>

#include "core/error.hpp"
#include "core/path_text.hpp"

namespace fs = std::filesystem;

namespace rva {
namespace {

constexpr std::string_view replaced = "-replaced";

// The names of staging folders (two numbers), of temporary files (one number), and of earlier results that
// were moved aside for either.
const std::regex& pattern() {
  static const std::regex one(R"((.*)\.partial-([0-9]{1,9})(-[0-9]+)?(-replaced)?)");
  return one;
}

bool belongs_to(const fs::path& entry, const std::string& target_name) {
  const std::string name = entry.filename();
  std::smatch parts;
  return std::regex_match(name, parts, pattern()) && parts[1] == target_name;
}

std::vector<fs::path> remains_beside(const fs::path& target) {
  std::vector<fs::path> found;
  std::error_code failure;
  const std::string name = target.filename();
  for (const fs::directory_entry& entry : fs::directory_iterator(target.parent_path(), failure)) {
    if (belongs_to(entry.path(), name)) found.push_back(entry.path());
  }
  return found;
}

bool is_running(const std::string& process) {
  return ::kill(static_cast<::pid_t>(std::stol(process)), 0) == 0 || errno != ESRCH;
}

// A running program has locked its staging folder. A temporary file has no lock, but its name has
// the process.
bool is_in_use(const fs::path& remains) {
  std::smatch parts;
  const std::string name = remains.filename();
  if (!std::regex_match(name, parts, pattern())) return true;
  if (!parts[3].matched) return is_running(parts[2]);
  std::string staging = remains.native();
  if (parts[4].matched) staging.resize(staging.size() - replaced.size());
  std::error_code ignored;
  return fs::is_directory(fs::symlink_status(staging, ignored)) && FolderLock::try_lock(staging) == nullptr;
}

}  // namespace

StagingFolder::StagingFolder(const fs::path& target) {
  for (int attempt = 0; lock_ == nullptr; ++attempt) {
    std::error_code failure;
    path_ = target.native() + fmt::format(".partial-{}-{}", ::getpid(), attempt);
    const bool made = fs::create_directory(path_, failure);
    if (failure)
      throw Error(printable(target), fmt::format("cannot be created ({})", failure.message()),
                  "check the permissions and the free space there, or choose another location");
    // Until the folder is locked, another program may take it for an abandoned one and remove it.
    if (made) lock_ = FolderLock::try_lock(path_);
  }
}

std::vector<fs::path> recover_remains(const fs::path& target,
                                      const std::function<bool(const fs::path&)>& may_remove) {
  std::vector<fs::path> stay;
  std::error_code ignored;
  for (const fs::path& remains : remains_beside(target)) {
    if (is_in_use(remains)) continue;
    const bool aside = remains.native().ends_with(replaced);
    if (aside && !fs::exists(fs::symlink_status(target, ignored)))
      fs::rename(remains, target, ignored);
    else if (may_remove(remains))
      fs::remove_all(remains, ignored);
    if (fs::exists(fs::symlink_status(remains, ignored))) stay.push_back(remains);
  }
  return stay;
}

bool is_name_of_remains(const fs::path& name) {
  return std::regex_match(name.filename().native(), pattern());
}

}  // namespace rva
