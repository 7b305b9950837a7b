// Long work, one task at a time, on a thread of its own.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <thread>

#include "core/progress.hpp"
#include "inspect/side_capture.hpp"
#include "inspect/task.hpp"

namespace rva {

/// Every member may be called from any thread. A check of readiness or of a baseline ends when another
/// task is to start.
class TaskRunner {
 public:
  using Work = std::function<void()>;

  TaskRunner() = default;
  ~TaskRunner();  ///< ends a task under way, as cancel() does
  TaskRunner(const TaskRunner&) = delete;
  TaskRunner& operator=(const TaskRunner&) = delete;

  /// How often somebody has cancelled or stopped so far. A start that was asked for before the last time does
  /// not happen: ask for it at the beginning of a request.
  [[nodiscard]] std::uint64_t ends_asked_for() const;

  /// @param prepare looks at what is to be worked on, and gives the work; nothing else starts meanwhile, and
  ///                what runs `between_starts()` waits
  /// @throws Error when another task is under way, or somebody cancelled since `ends_asked_for`; what
  /// `prepare`
  ///         throws
  void start(TaskState task, std::uint64_t ends_asked_for, const std::function<Work()>& prepare);

  /// Changes what tasks read, while none is about to start.
  template <typename Change>
  auto between_starts(const Change& change) {
    const std::lock_guard starting(starting_);
    return change();
  }

  /// Ends the task under way, if any: soon after.
  void cancel();
  /// The same where it is a capture.
  void stop_capture();

  [[nodiscard]] TaskState task() const;
  void update(const std::function<void(TaskState&)>& change);

  // For work: each throws Interrupted when it is to end.

  void throw_if_ended() const;
  [[nodiscard]] Progress counted_progress();
  [[nodiscard]] CaptureEvents capture_events();

 private:
  void run(const Work& work);
  void end_check();
  void require_free(std::uint64_t ends_asked_for) const;

  mutable std::mutex mutex_;  // guards the next two
  TaskState task_;
  std::uint64_t ends_asked_for_ = 0;
  std::mutex starting_;  // guards the thread
  std::atomic<bool> cancelled_ = false;
  std::thread thread_;
};

}  // namespace rva
