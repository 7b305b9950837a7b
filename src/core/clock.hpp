// The clock that timed work uses: the machine's, or a simulated one that a test advances.
#pragma once

#include <algorithm>
#include <chrono>
#include <functional>
#include <memory>
#include <thread>

#include "core/interrupt.hpp"

namespace rva {

/// Both functions may be called from any thread, unless the function that makes the clock states otherwise.
struct Clock {
  std::function<double()> now_s;                 ///< never decreases; only differences are meaningful
  std::function<void(double duration_s)> sleep;  ///< returns when now_s() has advanced by about so much
};

/// The machine's clock, in seconds since it was started.
[[nodiscard]] inline Clock steady_clock() {
  return {[] {
            const auto since_start = std::chrono::steady_clock::now().time_since_epoch();
            return std::chrono::duration<double>(since_start).count();
          },
          [](double duration_s) { std::this_thread::sleep_for(std::chrono::duration<double>(duration_s)); }};
}

/// A simulated clock that starts at 0 and is advanced by sleep() alone, without waiting: for simulations that
/// do not run in real time. Not for use by several threads.
[[nodiscard]] inline Clock unhurried_clock() {
  const auto now_s = std::make_shared<double>(0.0);
  return {[now_s] { return *now_s; }, [now_s](double duration_s) { *now_s += duration_s; }};
}

/// Returns when the clock has reached the time, at once if it has. @throws Interrupted soon after a signal
inline void wait_until(const Clock& clock, double time_s) {
  constexpr double longest_sleep_s = 0.05;  // short enough for Ctrl-C to seem immediate
  for (double left_s = time_s - clock.now_s(); left_s > 0.0; left_s = time_s - clock.now_s()) {
    throw_if_interrupted();
    clock.sleep(std::min(left_s, longest_sleep_s));
  }
}

}  // namespace rva
