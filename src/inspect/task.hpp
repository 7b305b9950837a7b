// The state of the current task, which all consoles show.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "core/enum_names.hpp"
#include "inspect/inspection.hpp"
#include "inspect/noise_watch.hpp"
#include "inspect/side_capture.hpp"

namespace rva {

/// What a task does.
enum class TaskKind {
  readiness,
  capture,
  check,  ///< comparison of a complete baseline with itself (check_baseline())
  comparison,
  signing,  ///< of a closed inspection
};
template <>
inline constexpr auto enum_names<TaskKind> = std::to_array<EnumName<TaskKind>>({
    {TaskKind::readiness, "readiness"},
    {TaskKind::capture, "capture"},
    {TaskKind::check, "check"},
    {TaskKind::comparison, "comparison"},
    {TaskKind::signing, "signing"},
});

/// Whether a task is running, or how it ended.
enum class TaskEnd {
  running,
  done,
  cancelled,  ///< by the user, by the next task or by a signal; what was complete is kept
  failed,     ///< see `problem`
};
template <>
inline constexpr auto enum_names<TaskEnd> = std::to_array<EnumName<TaskEnd>>({
    {TaskEnd::running, "running"},
    {TaskEnd::done, "done"},
    {TaskEnd::cancelled, "cancelled"},
    {TaskEnd::failed, "failed"},
});

/// The state of the running task, or of the last one.
struct TaskState {
  std::uint64_t number = 0;  ///< from 1, in the order of the tasks since the program started; 0: none yet
  TaskKind kind = TaskKind::readiness;
  TaskEnd end = TaskEnd::done;
  std::int64_t inspection = 0;  ///< 0 if the task does not belong to an inspection
  Side side = Side::initial;    ///< for captures only
  CaptureProgress progress{};   ///< for captures only
  std::size_t done = 0;         ///< steps of `total`, for tasks other than captures
  std::size_t total = 0;
  std::string waiting{};                      ///< why the task waits for a device; empty if it does not
  std::string problem{};                      ///< why the task failed
  std::shared_ptr<const NoiseSoFar> noise{};  ///< of the current view, or of the last one; null before that
};

}  // namespace rva
