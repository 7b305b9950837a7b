// Times of things that are to be compared, taken in turn.
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
  std::function<void()> prepare = [] {};  // before each run, not timed
  double least_ms = std::numeric_limits<double>::infinity();
};

/// Runs every candidate once a round, one after the other, so that a machine that slows down slows all of
/// them, and keeps each one's least time: what it takes when nothing disturbs it.
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
