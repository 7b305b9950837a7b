#include "server/complaints.hpp"

#include <fmt/format.h>

namespace rva {

void Complaints::add(const std::string& kind, double now_s) {
  constexpr double pause_s = 60.0;
  const std::lock_guard lock(mutex_);
  const auto [found, is_new] = counts_.try_emplace(kind, Count{now_s, 0});
  Count& count = found->second;
  if (!is_new && now_s - count.told_s < pause_s) {
    ++count.since;
    return;
  }
  log_(count.since > 0 ? fmt::format("{} ({} more since)", kind, count.since) : kind);
  count = {now_s, 0};
}

}  // namespace rva
