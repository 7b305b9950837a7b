#include "inspect/task_runner.hpp"

#include <exception>
#include <memory>
#include <string>
#include <utility>

#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "core/path_text.hpp"

namespace rva {

TaskRunner::~TaskRunner() {
  cancel();
  if (thread_.joinable()) thread_.join();
}

std::uint64_t TaskRunner::ends_asked_for() const {
  const std::lock_guard lock(mutex_);
  return ends_asked_for_;
}

void TaskRunner::start(TaskState task, std::uint64_t ends_asked_for, const std::function<Work()>& prepare) {
  const std::lock_guard starting(starting_);
  end_check();
  {
    const std::lock_guard lock(mutex_);
    require_free(ends_asked_for);
  }
  Work work = prepare();
  if (thread_.joinable()) thread_.join();
  {
    const std::lock_guard lock(mutex_);
    require_free(ends_asked_for);
    task.number = task_.number + 1;
    task.end = TaskEnd::running;
    task_ = std::move(task);
    cancelled_ = false;
  }
  thread_ = std::thread([this, work = std::move(work)] { run(work); });
}

// Call with mutex_ locked.
void TaskRunner::require_free(std::uint64_t ends_asked_for) const {
  if (task_.end == TaskEnd::running)
    throw Error(std::string(name_of(task_.kind)), "is in progress", "wait for its end, or cancel it");
  if (ends_asked_for_ != ends_asked_for)
    throw Error("start", "was stopped or cancelled before it began", "try again");
}

// A new task does not wait for a check to finish: the check is ended.
void TaskRunner::end_check() {
  const TaskState now = task();
  const bool is_check = now.kind == TaskKind::readiness || now.kind == TaskKind::check;
  if (now.end != TaskEnd::running || !is_check) return;
  cancelled_ = true;
  thread_.join();
}

void TaskRunner::run(const Work& work) {
  TaskEnd end = TaskEnd::done;
  std::string problem;
  try {
    work();
  } catch (const Interrupted&) {
    end = TaskEnd::cancelled;
  } catch (const std::exception& failure) {
    end = TaskEnd::failed;
    problem = printable(failure.what());
  }
  update([&](TaskState& task) {
    task.end = end;
    task.problem = problem;
    task.waiting.clear();
    ++ended_[{task.kind, end}];
  });
}

void TaskRunner::cancel() {
  const std::lock_guard lock(mutex_);
  ++ends_asked_for_;
  cancelled_ = true;
}

void TaskRunner::stop_capture() {
  const std::lock_guard lock(mutex_);
  ++ends_asked_for_;
  if (task_.end == TaskEnd::running && task_.kind == TaskKind::capture) cancelled_ = true;
}

TaskState TaskRunner::task() const {
  const std::lock_guard lock(mutex_);
  return task_;
}

EndedTasks TaskRunner::ended() const {
  const std::lock_guard lock(mutex_);
  return ended_;
}

void TaskRunner::update(const std::function<void(TaskState&)>& change) {
  const std::lock_guard lock(mutex_);
  change(task_);
}

void TaskRunner::throw_if_ended() const {
  if (cancelled_) throw Interrupted(0);
  throw_if_interrupted();
}

// A cancelled task ends when it next reports progress, as after Ctrl-C.
Progress TaskRunner::counted_progress() {
  return [this](std::string_view /*step*/, std::size_t done, std::size_t total) {
    throw_if_ended();
    update([&](TaskState& task) {
      task.done = done;
      task.total = total;
    });
  };
}

CaptureEvents TaskRunner::capture_events() {
  return {[this](const CaptureProgress& progress) {
            throw_if_ended();
            update([&](TaskState& task) { task.progress = progress; });
          },
          [this](NoiseSoFar noise) {
            update([shared = std::make_shared<const NoiseSoFar>(std::move(noise))](TaskState& task) {
              task.noise = shared;
            });
          },
          [this](const std::string& why) { update([&](TaskState& task) { task.waiting = why; }); }};
}

}  // namespace rva
