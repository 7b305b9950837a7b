// Time that a test turns by hand; sleeping turns it, so that no test waits.
#pragma once

#include "core/clock.hpp"

namespace rva::test {

/// Must outlive the clocks it gave.
struct ManualClock {
  double now_s = 1000.0;

  [[nodiscard]] Clock clock() {
    return {[this] { return now_s; }, [this](double duration_s) { now_s += duration_s; }};
  }
};

}  // namespace rva::test
