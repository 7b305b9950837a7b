// Dithering: several captures of one view, from poses a few servo steps apart.
//
// The error of a stereo matcher depends on which dots of the projector fall on a surface, and is the same in
// every frame from one pose. From a pose a few steps away, other dots fall there.
#pragma once

#include <vector>

#include "robot/robot.hpp"

namespace rva {

/// Step of a Herkulex DRS-0101 servo, which resolves 1024 positions over 333 degrees.
inline constexpr double servo_step_deg = 0.325;

/// Limit of the number of captures of one view.
inline constexpr int most_dithers = 16;

/// Offsets of captures from a waypoint: whole servo steps, 0 to 7 in each joint (0 to 2.3 degrees). The first
/// is 0, and the first `count` are spread over that square for any count.
/// @param count 1 to most_dithers
[[nodiscard]] std::vector<PanTilt> dither_offsets(int count);

/// The poses of a view's captures: the view plus each of dither_offsets(). In a joint in which these would
/// exceed the upper limit, they are subtracted instead.
/// @param count 1 to most_dithers
[[nodiscard]] std::vector<PanTilt> dithered(const PanTilt& view, int count, const RobotLimits& limits);

/// Moves to the target from smaller angles in both joints, so that the play of the servos is always taken up
/// on the same side, and waits until the robot rests.
/// @return joints() at rest
/// @throws UsageError, Error, Interrupted as move_and_wait()
PanTilt approach(Robot& robot, const PanTilt& target, const Clock& clock = steady_clock());

}  // namespace rva
