#include "evaluate/moved_study.hpp"

#include <algorithm>

#include "core/error.hpp"
#include "evaluate/moved_inspection.hpp"
#include "robot/dither.hpp"

namespace rva {
namespace {

void check(const MovedStudyOptions& options) {
  const bool ascending = std::ranges::is_sorted(options.captures, std::less_equal{});
  const bool in_range =
      !options.captures.empty() && options.captures.front() >= 1 && options.captures.back() <= most_dithers;
  if (!ascending || !in_range)
    throw UsageError("--captures", "needs numbers from 1 to 16, each larger than the one before",
                     "give for example 1,4,8");
}

}  // namespace

std::vector<MovedInspection> run_moved_study(
    const MovedStudyOptions& options, std::vector<MovedInspection> earlier, const Progress& progress,
    const std::function<void(const std::vector<MovedInspection>&)>& keep) {
  check(options);
  std::vector<MovedInspection> done = std::move(earlier);
  const auto total = static_cast<std::size_t>(options.inspections);
  if (done.size() > total) done.resize(total);
  for (std::size_t i = done.size(); i < total; ++i) {
    done.push_back(inspect_moved(options, options.first_seed + i));
    if (keep) keep(done);
    if (progress) progress("inspections", i + 1, total);
  }
  return done;
}

}  // namespace rva
