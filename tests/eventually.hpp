// Waiting for another thread with a deadline, so that a test that waits in vain fails instead of hanging.
#pragma once

#include <chrono>
#include <thread>

namespace rva::test {

/// Waits until the condition is true.
/// @return false if it was not true within a minute, which is long enough for sanitizers on a busy computer
template <typename Condition>
[[nodiscard]] bool eventually(const Condition& condition) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  while (!condition()) {
    if (std::chrono::steady_clock::now() > deadline) return false;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  return true;
}

}  // namespace rva::test
