// Measures how long work takes.
#pragma once

#include <chrono>

namespace rva {

/// Starts when it is constructed.
class Stopwatch {
 public:
  /// Time since its construction, milliseconds.
  [[nodiscard]] double ms() const {
    return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count();
  }

 private:
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

}  // namespace rva
