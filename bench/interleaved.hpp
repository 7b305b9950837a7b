// Interleaved timing of candidates that are to be compared.
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace rva::bench {

struct Candidate {
  std::string name;
  std::function<void()> run;
  std::function<void()> prepare = [] {};  // called before each run, not timed
  double least_ms = std::numeric_limits<double>::infinity();
};

/// Runs every candidate once per round, one after the other, so that changes of the machine's speed affect
/// all of them, and keeps the least time of each, which is the least disturbed.
inline void time_interleaved(std::vector<Candidate>& candidates, int rounds) {
  using Clock = std::chrono::steady_clock;
  for (int round = 0; round < rounds; ++round) {
    for (Candidate& candidate : candidates) {
      candidate.prepare();
      const auto start = Clock::now();
      candidate.run();
      const double ms = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
      candidate.least_ms = std::min(candidate.least_ms, ms);
    }
  }
}

}  // namespace rva::bench
