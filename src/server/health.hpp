// Whether the server can do its work, for programs that watch it (docs/api.md).
#pragma once

#include <string>
#include <vector>

#include "server/json_of.hpp"
#include "server/server_parts.hpp"

namespace rva {

/// One aspect of the server's health.
struct HealthCheck {
  std::string name;     ///< "camera", "robot" (only where there is one), "data", "disk", "records"
  std::string problem;  ///< what is wrong and what to do, without names of folders; empty if nothing is
};

/// All checks, in that order. May be called from any thread. Never throws.
[[nodiscard]] std::vector<HealthCheck> check_health(const ServerParts& parts);

/// What is wrong with a camera in this state; empty if nothing is.
[[nodiscard]] std::string camera_problem(const CameraHealth& health);

/// Whether no check has a problem.
[[nodiscard]] bool is_healthy(const std::vector<HealthCheck>& checks);

[[nodiscard]] Json json_of(const std::vector<HealthCheck>& checks);

}  // namespace rva
