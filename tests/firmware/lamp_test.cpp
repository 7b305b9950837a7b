#include "firmware/rva_robot/lamp.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>

namespace rva::test {
namespace {

using rva_robot::heat_of;

TEST(LampHeat, FollowsTheThermistorsEquationWithinADegree) {
  for (double celsius = -19.5; celsius < 100.0; celsius += 0.5) {
    const double ratio = std::exp(3950.0 * (1.0 / (celsius + 273.15) - 1.0 / 298.15));
    const auto counts = static_cast<std::uint16_t>(std::lround(1023.0 * ratio / (1.0 + ratio)));
    EXPECT_NEAR(heat_of(counts) / 10.0, celsius, 1.0);
  }
}

TEST(LampHeat, HasNoneWhereTheThermistorIsCutOrShorted) {
  EXPECT_EQ(heat_of(1023), rva_robot::no_heat);
  EXPECT_EQ(heat_of(0), rva_robot::no_heat);
}

TEST(LampHeat, FallsWithTheCounts) {
  for (std::uint16_t counts = 67; counts < 934; ++counts) EXPECT_GE(heat_of(counts), heat_of(counts + 1));
}

}  // namespace
}  // namespace rva::test
