// The built firmware on a simulated board with simulated servos, at the end of a pseudo terminal, and a file
// with the true angles of the servos: the robot for `rva map --robot serial:LINK --camera
// sim:SCENE,joints=FILE`.
//
// usage: robot_in_the_loop LINK FILE [--faults]
//
// Runs until its standard input ends. With --faults, servos lose packets and replies, flip bits and set the
// undocumented bits of their positions.
#include <fmt/format.h>
#include <poll.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>

#include "tests/firmware/pty_board.hpp"

namespace {

using rva::test::Board;

void worry(Board& board) {
  for (rva::test::SimulatedServo* const servo : {&board.pan(), &board.tilt()})
    servo->faults = {
        .packet_lost = 0.05, .reply_lost = 0.2, .bit_flipped = 0.002, .high_bits = 0xC0, .error = 0};
}

// Written beside and renamed, so that a reader finds two whole numbers.
void write_angles(const std::string& file, double pan_deg, double tilt_deg) {
  const std::string partial = file + ".partial";
  std::ofstream(partial) << fmt::format("{:.6f} {:.6f}\n", pan_deg, tilt_deg);
  std::filesystem::rename(partial, file);
}

bool input_ended(int wait_ms) {
  pollfd input{STDIN_FILENO, POLLIN, 0};
  if (poll(&input, 1, wait_ms) <= 0) return false;
  char byte = 0;
  return read(STDIN_FILENO, &byte, 1) == 0;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 3 || argc > 4) {
    fmt::print(stderr, "usage: robot_in_the_loop LINK FILE [--faults]\n");
    return 2;
  }
  if (rva::test::simulated_board() == nullptr) {
    fmt::print(stderr, "robot_in_the_loop: the firmware was not built\n");
    return 77;
  }
  rva::test::PtyBoard robot(argv[1], [] { return rva::test::simulated_board(); });
  if (argc == 4) robot.with_board(worry);
  bool ready = false;
  do {
    double pan_deg = 0.0;
    double tilt_deg = 0.0;
    robot.with_board([&](Board& board) {
      pan_deg = board.pan().angle_deg();
      tilt_deg = board.tilt().angle_deg();
    });
    write_angles(argv[2], pan_deg, tilt_deg);
    if (!ready) fmt::print("ready\n");
    ready = true;
    std::fflush(stdout);
  } while (!input_ended(5));
  return 0;
}
