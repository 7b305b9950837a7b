#include "core/parallel.hpp"

#include <algorithm>
#include <atomic>
#include <exception>
#include <thread>
#include <vector>

namespace rva {

namespace {

// More bands than cores, so that a core with easy rows takes over from one with hard ones.
constexpr int bands_per_core = 4;

}  // namespace

// Starts its threads anew in each call, which takes 27 us on two cores. oneTBB would reuse them, but the
// thread sanitizer (preset `threads`) does not see how Debian's build of it synchronises, and would report a
// race in every loop.
void parallel_bands(int rows, const std::function<void(int, int)>& work) {
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int bands = std::clamp(rows, 1, cores == 1 ? 1 : bands_per_core * cores);
  std::vector<std::exception_ptr> failures(static_cast<std::size_t>(bands));
  std::atomic<int> next = 0;
  const auto run = [&] {
    for (int band = next++; band < bands; band = next++) {
      try {
        work(rows * band / bands, rows * (band + 1) / bands);
      } catch (...) {
        failures[static_cast<std::size_t>(band)] = std::current_exception();
      }
    }
  };
  {
    std::vector<std::jthread> threads;
    for (int thread = 1; thread < std::min(cores, bands); ++thread) threads.emplace_back(run);
    run();
  }
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

}  // namespace rva
