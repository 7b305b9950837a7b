#include "motion.h"

#include "herkulex.h"

namespace rva_robot {
namespace {

constexpr uint32_t tenth_ms_a_unit = 112;
// Moves with a play time up to this accelerate for the share `acceleration_percent`, longer ones for the
// longest time.
constexpr uint32_t all_share_play = longest_acceleration_play * 100UL / acceleration_percent;

constexpr uint32_t divide_up(uint32_t number, uint32_t by) { return (number + by - 1) / by; }

}  // namespace

// The speed profile is a trapezoid: distance = fastest speed * (play - acceleration).
uint16_t play_of(uint16_t distance_cdeg, int16_t speed_cdeg_s) {
  const uint32_t at_full_speed =
      divide_up(10000UL * distance_cdeg, tenth_ms_a_unit * static_cast<uint32_t>(speed_cdeg_s));
  const uint32_t by_share = divide_up(at_full_speed * 100, 100 - acceleration_percent);
  const uint32_t play = by_share <= all_share_play ? by_share : at_full_speed + longest_acceleration_play;
  return static_cast<uint16_t>(play < 1 ? 1 : play);
}

uint16_t farthest_cdeg(int16_t speed_cdeg_s) {
  const uint32_t at_full_speed = herkulex::longest_play - longest_acceleration_play;
  return static_cast<uint16_t>(at_full_speed * tenth_ms_a_unit * static_cast<uint32_t>(speed_cdeg_s) /
                               10000UL);
}

}  // namespace rva_robot
