#include "firmware/rva_robot/motion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdint>

namespace rva::test {
namespace {

constexpr double s_a_play = 0.0112;

double fastest_deg_s(double distance_deg, double play) {
  const double duration_s = play * s_a_play;
  return distance_deg / (duration_s - std::min(0.25 * duration_s, 45 * s_a_play));
}

TEST(Motion, NoMomentOfAMoveIsFasterThanAskedAndNoneMuchSlower) {
  for (std::int16_t speed_cdeg_s = 100; speed_cdeg_s <= 9000;
       speed_cdeg_s = static_cast<std::int16_t>(speed_cdeg_s + 137)) {
    for (int distance_cdeg = 1; distance_cdeg <= 18000; distance_cdeg += 23) {
      const std::uint16_t play = rva_robot::play_of(static_cast<std::uint16_t>(distance_cdeg), speed_cdeg_s);
      EXPECT_LE(fastest_deg_s(distance_cdeg / 100.0, play), speed_cdeg_s / 100.0 + 1e-9);
      if (play > 4) {
        EXPECT_GT(fastest_deg_s(distance_cdeg / 100.0, play - 3), speed_cdeg_s / 100.0);
      }
    }
  }
}

TEST(Motion, TheFarthestMoveFitsIntoAPacket) {
  for (std::int16_t speed_cdeg_s = 100; speed_cdeg_s <= 9000; ++speed_cdeg_s)
    EXPECT_LE(rva_robot::play_of(rva_robot::farthest_cdeg(speed_cdeg_s), speed_cdeg_s), 254) << speed_cdeg_s;
}

}  // namespace
}  // namespace rva::test
