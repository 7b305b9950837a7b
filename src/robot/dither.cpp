#include "robot/dither.hpp"

#include <algorithm>
#include <array>
#include <cassert>

namespace rva {
namespace {

struct Steps {
  int pan = 0;
  int tilt = 0;
};

// No two of the first eight have the same pan or tilt, and each group of four has one in each quarter of
// the square.
constexpr std::array<Steps, most_dithers> offsets{{{0, 0},
                                                   {4, 5},
                                                   {2, 6},
                                                   {6, 3},
                                                   {1, 2},
                                                   {5, 7},
                                                   {3, 4},
                                                   {7, 1},
                                                   {0, 4},
                                                   {4, 1},
                                                   {2, 2},
                                                   {6, 7},
                                                   {1, 6},
                                                   {5, 3},
                                                   {3, 0},
                                                   {7, 5}}};

}  // namespace

std::vector<PanTilt> dither_offsets(int count) {
  assert(count >= 1 && count <= most_dithers);
  std::vector<PanTilt> result;
  for (int k = 0; k < count; ++k) {
    const Steps& steps = offsets.at(static_cast<std::size_t>(k));
    result.push_back({servo_step_deg * steps.pan, servo_step_deg * steps.tilt});
  }
  return result;
}

std::vector<PanTilt> dithered(const PanTilt& view, int count, const RobotLimits& limits) {
  constexpr double most_dither_deg = 2.3;
  const double pan_sign = view.pan_deg + most_dither_deg > limits.pan.max_deg ? -1.0 : 1.0;
  const double tilt_sign = view.tilt_deg + most_dither_deg > limits.tilt.max_deg ? -1.0 : 1.0;
  std::vector<PanTilt> waypoints;
  for (const PanTilt& offset : dither_offsets(count))
    waypoints.push_back(
        {view.pan_deg + pan_sign * offset.pan_deg, view.tilt_deg + tilt_sign * offset.tilt_deg});
  return waypoints;
}

PanTilt approach(Robot& robot, const PanTilt& target, const Clock& clock) {
  constexpr double run_up_deg = 1.0;  // more than the play of a worn servo
  const RobotLimits limits = robot.limits();
  move_and_wait(robot,
                {std::max(target.pan_deg - run_up_deg, limits.pan.min_deg),
                 std::max(target.tilt_deg - run_up_deg, limits.tilt.min_deg)},
                clock);
  return move_and_wait(robot, target, clock);
}

}  // namespace rva
