// What the program is doing for an inspection, for all who watch.
#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>

#include "inspect/inspection.hpp"
#include "inspect/noise_watch.hpp"
#include "inspect/side_capture.hpp"

namespace rva {

enum class TaskKind {
  readiness,
  capture,
  check,  ///< of a baseline that is complete
  comparison,
};
[[nodiscard]] std::string_view name_of(TaskKind kind);

enum class TaskEnd {
  running,
  done,
  cancelled,  ///< by a person; what was complete is kept
  failed,     ///< see `problem`
};
[[nodiscard]] std::string_view name_of(TaskEnd end);

struct TaskState {
  std::uint64_t number = 0;  ///< of the tasks since the program began; 0: there was none
  TaskKind kind = TaskKind::readiness;
  TaskEnd end = TaskEnd::done;
  std::int64_t inspection = 0;  ///< 0 of a task that is about none
  Side side = Side::initial;    ///< of a capture
  CaptureProgress progress{};   ///< of a capture
  std::size_t done = 0;         ///< of `total`; of other tasks
  std::size_t total = 0;
  std::string waiting{};                      ///< for a device that is away: why
  std::string problem{};                      ///< why it failed
  std::shared_ptr<const NoiseSoFar> noise{};  ///< of the view under way, or of the last one; null before
};

}  // namespace rva
