// The play time that a move needs so that its peak speed stays within a limit.
#ifndef RVA_ROBOT_MOTION_H
#define RVA_ROBOT_MOTION_H

#include <stdint.h>

namespace rva_robot {

/// A servo accelerates for this share of a move and decelerates for as long, each limited to the time below.
constexpr uint8_t acceleration_percent = 25;
constexpr uint8_t longest_acceleration_play = 45;  ///< 504 ms

/// The play time, in units of 11.2 ms, of a move whose peak speed does not exceed `speed_cdeg_s`; values
/// above 254 do not fit into one packet.
uint16_t play_of(uint16_t distance_cdeg, int16_t speed_cdeg_s);

/// The longest distance of one packet at this peak speed.
uint16_t farthest_cdeg(int16_t speed_cdeg_s);

constexpr uint16_t ms_of_play(uint8_t play) { return static_cast<uint16_t>(play * 112UL / 10UL); }

}  // namespace rva_robot

#endif
