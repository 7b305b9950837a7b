#include "server/data_folder_probe.hpp"

#include "core/error.hpp"
#include "core/folder_space.hpp"

namespace rva {

std::string DataFolderProbe::problem(const std::filesystem::path& folder, double now_s) {
  constexpr double valid_s = 10.0;
  const std::lock_guard lock(mutex_);
  if (checked_s_ && now_s - *checked_s_ < valid_s) return problem_;
  checked_s_ = now_s;
  problem_.clear();
  try {
    require_writable(folder);
  } catch (const Error& error) {
    problem_ = error.what();
  }
  return problem_;
}

}  // namespace rva
