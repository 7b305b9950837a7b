// Changes of the server's state, as events for its log.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "core/event.hpp"
#include "inspect/task.hpp"
#include "server/health.hpp"

namespace rva {

/// Compares each state with the one before it. The first one is compared with a healthy server that has done
/// no task.
class StateEvents {
 public:
  /// "camera-failed" when a check finds a problem, "camera-back" when it finds none any more, and so on for
  /// each check. A problem that changes its text meanwhile is not a new event.
  [[nodiscard]] std::vector<Event> of_health(const std::vector<HealthCheck>& checks, double now_s);

  /// "task-started" and "task-ended". Names of people and aircraft are in no event.
  [[nodiscard]] std::vector<Event> of_task(const TaskState& task, double now_s);

 private:
  std::map<std::string, double> failed_s_;  // when each failing check began to fail
  std::uint64_t started_ = 0;               // number of the last task whose start was an event
  std::uint64_t ended_ = 0;                 // likewise of its end
  double started_s_ = 0.0;
};

}  // namespace rva
