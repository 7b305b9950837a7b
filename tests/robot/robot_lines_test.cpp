#include "robot/robot_lines.hpp"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/firmware/golden_lines.hpp"

namespace rva {
namespace {

using test::golden_lines;

template <typename Said>
Said said(const std::string& line) {
  const auto parsed = parse_robot_line(line);
  EXPECT_TRUE(parsed && std::holds_alternative<Said>(*parsed)) << line;
  return parsed && std::holds_alternative<Said>(*parsed) ? std::get<Said>(*parsed) : Said{};
}

TEST(RobotLines, FramesToTheRobotAreTheGoldenOnes) {
  const std::vector<std::string> golden = golden_lines("host");
  ASSERT_EQ(golden.size(), 6U);
  EXPECT_EQ(robot_frame(0, "PING"), golden[0] + "\n");
  EXPECT_EQ(robot_frame(1, move_body({45.0, -10.5})), golden[1] + "\n");
  EXPECT_EQ(robot_frame(3, "STOP"), golden[3] + "\n");
  EXPECT_EQ(robot_frame(255, "INFO"), golden[5] + "\n");
}

TEST(RobotLines, GoldenLinesFromTheRobotAreUnderstood) {
  const std::vector<std::string> golden = golden_lines("robot");
  ASSERT_EQ(golden.size(), 8U);
  const auto ready = said<ReadyLine>(golden[0]);
  EXPECT_EQ(ready.protocol, 1);
  EXPECT_EQ(ready.firmware, "1.0.0");
  EXPECT_EQ(ready.limits, RobotLimits{});
  EXPECT_EQ(said<AnswerLine>(golden[1]).number, 255);
  EXPECT_EQ(said<AnswerLine>(golden[1]).refusal, "");
  EXPECT_EQ(said<AnswerLine>(golden[2]).refusal, "LIMIT");
  EXPECT_EQ(said<AnswerLine>(golden[3]).refusal, "CRC");
  const auto positions = said<PositionsLine>(golden[4]);
  EXPECT_EQ(positions.pan->deg, 45.18);
  EXPECT_EQ(positions.pan->age_s, 0.003);
  EXPECT_EQ(positions.tilt->deg, -10.4);
  EXPECT_EQ(positions.state, "MOVE");
  EXPECT_FALSE(said<PositionsLine>(golden[5]).pan.has_value()) << "no angle that was not measured";
  EXPECT_EQ(said<StatusLine>(golden[6]).rest, "00 42 12.0 140");
  EXPECT_EQ(said<StatusLine>(golden[7]).axis, "TILT");
}

TEST(RobotLines, DamagedFramesSayNothing) {
  for (const std::string& golden : golden_lines("robot")) {
    for (std::size_t i = 0; i < golden.size(); ++i) {
      for (int bit = 0; bit < 8; ++bit) {
        std::string damaged = golden;
        damaged[i] = static_cast<char>(damaged[i] ^ (1 << bit));
        EXPECT_FALSE(parse_robot_line(damaged)) << damaged;
      }
      EXPECT_FALSE(parse_robot_line(golden.substr(0, i))) << i;
    }
  }
}

TEST(RobotLines, PositionsOfTheThesisFirmwareAreUnderstoodWholeOrNotAtAll) {
  EXPECT_EQ(said<BarePositionsLine>("12.03x-29.90").joints, (PanTilt{12.03, -29.9}));
  for (const std::string line :
       {"", "x", "12.03", "12.03x", "12.03x-29.9", "2.0x-29.90", "12x-29.90", "a2.03x-29.90", "12.03x-29.900",
        "12.03x-29.90 ", "nanx-29.90", "$12.03x-29.90", "$", "$*"})
    EXPECT_FALSE(parse_robot_line(line)) << line;
}

}  // namespace
}  // namespace rva
