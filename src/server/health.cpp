#include "server/health.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>

#include "core/clock.hpp"
#include "core/folder_space.hpp"
#include "core/path_text.hpp"
#include "server/private_paths.hpp"

namespace rva {
namespace {

constexpr double bytes_per_gb = 1e9;

std::string disk_problem(const ServerParts& parts) {
  const double free_gb = static_cast<double>(space_of(parts.inspector.data()).free_bytes) / bytes_per_gb;
  const double least_gb = parts.inspector.readiness_options().least_free_gb;
  if (free_gb >= least_gb) return {};
  return fmt::format("disk: {:.1f} GB are free of at least {:.1f} GB that captures need; free some space",
                     free_gb, least_gb);
}

// Any question shows whether the database answers.
std::string records_problem(const ServerParts& parts) {
  static_cast<void>(parts.inspector.has(1));
  return {};
}

HealthCheck checked(const std::string& name, const std::function<std::string()>& problem) {
  try {
    return {name, without_folders(problem())};
  } catch (const std::exception& error) {
    return {name, without_folders(printable(error.what()))};
  }
}

}  // namespace

std::string camera_problem(const CameraHealth& health) {
  constexpr double longest_silence_s = 10.0;  // a slow simulated camera takes seconds for a frame
  if (!health.problem.empty()) return health.problem;
  if (health.silence_s < longest_silence_s) return {};
  return fmt::format("camera: has given no frame for {:.0f} seconds; check its cable, or connect it again",
                     health.silence_s);
}

std::vector<HealthCheck> check_health(const ServerParts& parts) {
  std::vector<HealthCheck> checks{checked("camera", [&] { return camera_problem(parts.camera.health()); })};
  if (parts.drive != nullptr)
    checks.push_back(checked("robot", [&] { return parts.drive->state().problem; }));
  checks.push_back(checked(
      "data", [&] { return parts.data_probe->problem(parts.inspector.data(), steady_clock().now_s()); }));
  checks.push_back(checked("disk", [&] { return disk_problem(parts); }));
  checks.push_back(checked("records", [&] { return records_problem(parts); }));
  return checks;
}

bool is_healthy(const std::vector<HealthCheck>& checks) {
  return std::ranges::all_of(checks, [](const HealthCheck& check) { return check.problem.empty(); });
}

Json json_of(const std::vector<HealthCheck>& checks) {
  Json json{{"healthy", is_healthy(checks)}, {"checks", Json::array()}};
  for (const HealthCheck& check : checks) {
    Json one{{"name", check.name}, {"healthy", check.problem.empty()}};
    if (!check.problem.empty()) one["problem"] = check.problem;
    json["checks"].push_back(std::move(one));
  }
  return json;
}

}  // namespace rva
