#include "evaluate/moved_study.hpp"

#include <algorithm>
#include <exception>
#include <functional>
#include <map>
#include <mutex>
#include <thread>
#include <utility>

#include "core/error.hpp"
#include "evaluate/moved_inspection.hpp"
#include "robot/dither.hpp"

namespace rva {
namespace {

// Limits memory on machines with many cores, since each inspection keeps its images in memory.
constexpr unsigned most_at_a_time = 8;

void check(const MovedStudyOptions& options) {
  const bool ascending = std::ranges::is_sorted(options.captures, std::less_equal{});
  const bool in_range =
      !options.captures.empty() && options.captures.front() >= 1 && options.captures.back() <= most_dithers;
  if (!ascending || !in_range)
    throw OptionError("captures", "requires numbers from 1 to 16 in ascending order",
                      "give for example 1,4,8");
  if (options.allowed.empty() || !std::ranges::is_sorted(options.allowed, std::less_equal{}))
    throw OptionError("allowed", "requires numbers in ascending order", "give for example 0.05,0.5");
  for (const double allowed : options.allowed) {
    CalibratedOptions calibrated;
    calibrated.false_findings = allowed;
    check_options(calibrated);
  }
}

/// Runs inspections on several threads, and passes the results on in the order of their seeds.
class Study {
 public:
  Study(const MovedStudyOptions& options, std::vector<MovedInspection> earlier, const Progress& progress,
        const std::function<void(const std::vector<MovedInspection>&)>& keep)
      : options_(options), progress_(progress), keep_(keep), done_(std::move(earlier)) {
    if (done_.size() > total()) done_.resize(total());
    next_ = done_.size();
  }

  std::vector<MovedInspection> run() {
    {
      const auto left = static_cast<unsigned>(std::min<std::size_t>(total() - next_, most_at_a_time));
      std::vector<std::jthread> threads;
      for (unsigned i = 0; i < std::min(left, std::max(1U, std::thread::hardware_concurrency())); ++i)
        threads.emplace_back([this] { work(); });
    }
    if (failure_) std::rethrow_exception(failure_);
    return std::move(done_);
  }

 private:
  [[nodiscard]] std::size_t total() const { return static_cast<std::size_t>(options_.inspections); }

  void work() {
    try {
      for (std::size_t i = take(); i < total(); i = take())
        hand_on(i, inspect_moved(options_, options_.first_seed + i));
    } catch (...) {
      const std::scoped_lock lock(mutex_);
      if (!failure_) failure_ = std::current_exception();
    }
  }

  // The index of the next inspection; total() if there is none or one failed.
  std::size_t take() {
    const std::scoped_lock lock(mutex_);
    return failure_ || next_ == total() ? total() : next_++;
  }

  void hand_on(std::size_t position, MovedInspection inspection) {
    const std::scoped_lock lock(mutex_);
    early_.emplace(position, std::move(inspection));
    const std::size_t before = done_.size();
    while (early_.contains(done_.size())) done_.push_back(std::move(early_.extract(done_.size()).mapped()));
    if (keep_ && done_.size() > before) keep_(done_);
    if (progress_) progress_("inspections", done_.size() + early_.size(), total());
  }

  const MovedStudyOptions& options_;
  const Progress& progress_;
  const std::function<void(const std::vector<MovedInspection>&)>& keep_;
  std::mutex mutex_;
  std::vector<MovedInspection> done_;
  std::map<std::size_t, MovedInspection> early_;  ///< done, but waiting for one of an earlier seed
  std::size_t next_ = 0;
  std::exception_ptr failure_;
};

}  // namespace

std::vector<MovedInspection> run_moved_study(
    const MovedStudyOptions& options, std::vector<MovedInspection> earlier, const Progress& progress,
    const std::function<void(const std::vector<MovedInspection>&)>& keep) {
  check(options);
  return Study(options, std::move(earlier), progress, keep).run();
}

}  // namespace rva
