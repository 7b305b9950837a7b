#include "core/parallel.hpp"

#include <algorithm>
#include <exception>
#include <thread>
#include <vector>

namespace rva {

void parallel_bands(int rows, const std::function<void(int, int)>& work) {
  const int cores = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
  const int bands = std::clamp(rows, 1, cores);
  std::vector<std::exception_ptr> failures(static_cast<std::size_t>(bands));
  const auto run = [&](int band) {
    try {
      work(rows * band / bands, rows * (band + 1) / bands);
    } catch (...) {
      failures[static_cast<std::size_t>(band)] = std::current_exception();
    }
  };
  {
    std::vector<std::jthread> threads;
    for (int band = 1; band < bands; ++band) threads.emplace_back(run, band);
    run(0);
  }
  for (const std::exception_ptr& failure : failures) {
    if (failure) std::rethrow_exception(failure);
  }
}

}  // namespace rva
