// Moves a robot through three waypoints and a few servo steps around each (dithers), and prints the joint
// angles that it reports at rest. Run it as `build/examples/talk_to_robot sim`, or with a serial device such
// as /dev/ttyACM0 in place of `sim` to move a real robot.
#include <fmt/format.h>

#include <array>
#include <string>
#include <string_view>

#include "core/clock.hpp"
#include "core/error.hpp"
#include "core/interrupt.hpp"
#include "robot/dither.hpp"
#include "robot/serial_robot.hpp"
#include "sim/simulated_robot.hpp"

namespace {

void visit(rva::Robot& robot, const rva::Clock& clock) {
  constexpr std::array waypoints{rva::PanTilt{-30.0, -20.0}, rva::PanTilt{0.0, -35.0},
                                 rva::PanTilt{30.0, -20.0}};
  constexpr int dithers = 4;
  for (const rva::PanTilt& waypoint : waypoints) {
    for (const rva::PanTilt& target : rva::dithered(waypoint, dithers, robot.limits())) {
      // Both joints arrive from below, so that the play of the servos is always on the same side.
      const rva::PanTilt joints = rva::approach(robot, target, clock);
      fmt::print("target {:8.3f} {:8.3f} deg, joints {:8.3f} {:8.3f} deg\n", target.pan_deg, target.tilt_deg,
                 joints.pan_deg, joints.tilt_deg);
    }
  }
}

void talk_to(std::string_view device) {
  if (device == "sim") {
    const rva::Clock clock = rva::unhurried_clock();  // simulated motion takes no time of ours
    rva::SimulatedRobot robot({}, clock.now_s);
    visit(robot, clock);
  } else {
    rva::SerialRobot robot{std::string(device)};  // waits until the firmware has identified itself
    visit(robot, rva::steady_clock());
  }
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    fmt::print(stderr, "usage: talk_to_robot sim|DEVICE\n");
    return 2;
  }
  rva::note_interrupts();  // Ctrl-C stops the robot before the program ends
  try {
    talk_to(argv[1]);
    return 0;
  } catch (const rva::Interrupted& interrupted) {
    return 128 + interrupted.signal();
  } catch (const rva::Error& error) {
    fmt::print(stderr, "talk_to_robot: {}\n", error.what());
    return 1;
  }
}
