// How long a move must take so that no moment of it is too fast.
#ifndef RVA_ROBOT_MOTION_H
#define RVA_ROBOT_MOTION_H

#include <stdint.h>

namespace rva_robot {

/// A servo speeds up for this share of a move, and slows down for as long, but for no longer than the second.
constexpr uint8_t acceleration_percent = 25;
constexpr uint8_t longest_acceleration_play = 45;  ///< 504 ms

/// Units of 11.2 ms of a move whose fastest moment is no faster than `speed_cdeg_s`; above 254 one packet
/// cannot say it.
uint16_t play_of(uint16_t distance_cdeg, int16_t speed_cdeg_s);

/// How far the longest move goes.
uint16_t farthest_cdeg(int16_t speed_cdeg_s);

constexpr uint16_t ms_of_play(uint8_t play) { return static_cast<uint16_t>(play * 112UL / 10UL); }

}  // namespace rva_robot

#endif
