// Runs long tasks, one at a time, on a thread of their own.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

#include "core/progress.hpp"
#include "inspect/side_capture.hpp"
#include "inspect/task.hpp"

namespace rva {

/// Number of tasks that have ended, by kind and end.
using EndedTasks = std::map<std::pair<TaskKind, TaskEnd>, std::uint64_t>;

/// Every member may be called from any thread. A check of readiness or of a baseline is ended when another
/// task is to start.
class TaskRunner {
 public:
  /// What a task does, on its own thread.
  using Work = std::function<void()>;

  TaskRunner() = default;
  ~TaskRunner();  ///< cancels the running task, if any, and waits for its end
  TaskRunner(const TaskRunner&) = delete;
  TaskRunner& operator=(const TaskRunner&) = delete;

  /// Number of calls of cancel() and stop_capture() so far. Read it at the beginning of a request and pass it
  /// to start(), which refuses requests that are older than the last of those calls.
  [[nodiscard]] std::uint64_t ends_asked_for() const;

  /// @param prepare checks whether the task is possible and returns its work; meanwhile no other task starts,
  ///                and between_starts() waits
  /// @throws Error when another task is running, or when cancel() or stop_capture() was called after
  ///         `ends_asked_for` was read; what `prepare` throws
  void start(TaskState task, std::uint64_t ends_asked_for, const std::function<Work()>& prepare);

  /// Calls `change`, which modifies what tasks read, while no task is being started.
  template <typename Change>
  auto between_starts(const Change& change) {
    const std::lock_guard starting(starting_);
    return change();
  }

  /// Asks the running task, if any, to end, and returns at once.
  void cancel();
  /// Like cancel(), but lets a task other than a capture continue.
  void stop_capture();

  [[nodiscard]] TaskState task() const;
  /// Since the object was constructed. What never happened is left out.
  [[nodiscard]] EndedTasks ended() const;
  void update(const std::function<void(TaskState&)>& change);

  // For use by the work. throw_if_ended() and both progress callbacks throw Interrupted once the task is to
  // end.

  void throw_if_ended() const;
  [[nodiscard]] Progress counted_progress();
  [[nodiscard]] CaptureEvents capture_events();

 private:
  void run(const Work& work);
  void end_check();
  void require_free(std::uint64_t ends_asked_for) const;

  mutable std::mutex mutex_;  // guards the next three
  TaskState task_;
  EndedTasks ended_;
  std::uint64_t ends_asked_for_ = 0;
  std::mutex starting_;  // guards the thread
  std::atomic<bool> cancelled_ = false;
  std::thread thread_;
};

}  // namespace rva
