#include "doctor/device_nodes.hpp"

#include <fmt/format.h>
#include <grp.h>
#include <pwd.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <system_error>

namespace fs = std::filesystem;

namespace rva {
namespace {

int number_in(const fs::path& file) {
  std::ifstream stream(file);
  int number = 0;
  return stream >> number ? number : 0;
}

std::vector<fs::path> entries(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code ignored;
  for (fs::directory_iterator entry(folder, ignored), end; !ignored && entry != end; entry.increment(ignored))
    found.push_back(entry->path());
  std::ranges::sort(found);
  return found;
}

std::string own_name() {
  const passwd* const user = getpwuid(geteuid());
  return user == nullptr ? std::to_string(geteuid()) : user->pw_name;
}

}  // namespace

bool may_read_and_write(const fs::path& node) { return access(node.c_str(), R_OK | W_OK) == 0; }

std::vector<fs::path> nodes_of(const PluggedIn& camera, const fs::path& dev) {
  std::vector<fs::path> nodes{
      dev / "bus/usb" /
      fmt::format("{:03}/{:03}", number_in(camera.folder / "busnum"), number_in(camera.folder / "devnum"))};
  // Each interface of the device is a folder in it, and lists its streams.
  for (const fs::path& interface : entries(camera.folder)) {
    for (const fs::path& stream : entries(interface / "video4linux"))
      nodes.push_back(dev / stream.filename());
  }
  std::erase_if(nodes, [](const fs::path& node) { return !fs::exists(node); });
  return nodes;
}

std::string advice_to_open(const fs::path& node) {
  struct stat state {};
  const bool known = stat(node.c_str(), &state) == 0;
  const bool group_may = known && (state.st_mode & (S_IRGRP | S_IWGRP)) == (S_IRGRP | S_IWGRP);
  if (!group_may || state.st_gid == 0)
    return "install rva-server, whose udev rules let groups open it, and plug it in again";
  const group* const entry = getgrgid(state.st_gid);
  return fmt::format("sudo adduser {} {}; then sign in again", own_name(),
                     entry == nullptr ? std::to_string(state.st_gid) : entry->gr_name);
}

}  // namespace rva
