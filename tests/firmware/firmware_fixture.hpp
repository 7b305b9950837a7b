// The firmware as its tests run it: its logic alone, and the built program.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <ostream>
#include <utility>

#include "tests/firmware/board.hpp"

namespace rva::test {

/// What runs the firmware.
enum class Kind { native, board };

inline std::ostream& operator<<(std::ostream& out, Kind kind) {
  return out << (kind == Kind::native ? "native" : "board");
}

/// Everything that a host sees is the same in the logic alone and in the built program.
class FirmwareTest : public testing::TestWithParam<Kind> {
 protected:
  static std::unique_ptr<Firmware> another() {
    return GetParam() == Kind::native ? native_firmware() : simulated_board();
  }
  Board board(Board::Start start = {0.0, 0.0, true}, std::uint64_t seed = 1) {
    std::unique_ptr<Firmware> firmware = another();
    return {std::move(firmware), start, seed};
  }
  void SetUp() override {
    if (GetParam() == Kind::board && !simulated_board())
      GTEST_SKIP()
          << "the board's program was not built: gcc-avr, arduino-core-avr or libsimavr-dev is missing";
  }
  // Sends PING every 100 ms meanwhile, as hosts do.
  static void run_in_sight_ms(Board& board, double ms) {
    for (double done = 0.0; done < ms; done += 100.0) {
      board.send_frame("PING");
      board.run_ms(std::min(100.0, ms - done));
    }
  }
};

}  // namespace rva::test
