// Captures of one place from a few servo steps apart.
//
// What a stereo matcher gets wrong depends on which dots of the projector fall on a surface, and is the same
// in every frame from one pose. A few steps aside, other dots do.
#pragma once

#include <vector>

#include "robot/robot.hpp"

namespace rva {

/// A Herkulex DRS-0101 resolves 1024 positions over 333 degrees.
inline constexpr double servo_step_deg = 0.325;
inline constexpr int most_dithers = 16;

/// Where captures are taken, from a waypoint: whole steps of the servos, 0 to 7 in each joint (2.3 degrees),
/// the first none, and any number of them spread over that square.
/// @param count 1 to most_dithers
[[nodiscard]] std::vector<PanTilt> dither_offsets(int count);

/// A view's captures: the view and its dithers, which lie on the other side where they would be beyond a
/// limit.
/// @param count 1 to most_dithers
[[nodiscard]] std::vector<PanTilt> dithered(const PanTilt& view, int count, const RobotLimits& limits);

/// Moves to the target from below in both joints, so that the play of the servos is always on one side, and
/// waits there. @return joints() at rest
/// @throws UsageError, Error, Interrupted  as move_and_wait()
PanTilt approach(Robot& robot, const PanTilt& target, const Clock& clock = steady_clock());

}  // namespace rva
