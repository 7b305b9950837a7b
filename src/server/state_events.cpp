#include "server/state_events.hpp"

#include <fmt/format.h>

namespace rva {
namespace {

std::string seconds(double duration_s) { return fmt::format("{:.1f}", duration_s); }

EventLevel level_of(TaskEnd end) {
  if (end == TaskEnd::failed) return EventLevel::warning;
  return end == TaskEnd::done ? EventLevel::info : EventLevel::notice;
}

Event task_event(const TaskState& task, const std::string& name, EventLevel level,
                 const std::string& message) {
  Event event{level, name, message, {{"kind", std::string(name_of(task.kind))}}};
  event.fields.emplace_back("task", std::to_string(task.number));
  if (task.inspection != 0) event.fields.emplace_back("inspection", std::to_string(task.inspection));
  return event;
}

}  // namespace

std::vector<Event> StateEvents::of_health(const std::vector<HealthCheck>& checks, double now_s) {
  std::vector<Event> events;
  for (const HealthCheck& check : checks) {
    const auto failed = failed_s_.find(check.name);
    if (!check.problem.empty() && failed == failed_s_.end()) {
      failed_s_[check.name] = now_s;
      events.push_back({EventLevel::warning, check.name + "-failed", check.problem});
    } else if (check.problem.empty() && failed != failed_s_.end()) {
      events.push_back({EventLevel::notice,
                        check.name + "-back",
                        check.name + ": works again",
                        {{"failed_s", seconds(now_s - failed->second)}}});
      failed_s_.erase(failed);
    }
  }
  return events;
}

std::vector<Event> StateEvents::of_task(const TaskState& task, double now_s) {
  std::vector<Event> events;
  if (task.number != started_) {
    started_ = task.number;
    started_s_ = now_s;
    events.push_back(
        task_event(task, "task-started", EventLevel::info, fmt::format("{}: started", name_of(task.kind))));
  }
  if (task.end == TaskEnd::running || task.number == ended_) return events;
  ended_ = task.number;
  std::string message = fmt::format("{}: {}", name_of(task.kind), name_of(task.end));
  if (!task.problem.empty()) message += ": " + task.problem;
  Event event = task_event(task, "task-ended", level_of(task.end), message);
  event.fields.emplace_back("end", std::string(name_of(task.end)));
  event.fields.emplace_back("duration_s", seconds(now_s - started_s_));
  events.push_back(std::move(event));
  return events;
}

}  // namespace rva
