#include "robot/robot_lines.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <boost/crc.hpp>
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
  ASSERT_EQ(golden.size(), 10U);
  EXPECT_EQ(robot_frame(0, "PING"), golden[0] + "\n");
  EXPECT_EQ(robot_frame(1, move_body({45.0, -10.5})), golden[1] + "\n");
  EXPECT_EQ(robot_frame(3, "STOP"), golden[3] + "\n");
  EXPECT_EQ(robot_frame(255, "INFO"), golden[5] + "\n");
  EXPECT_EQ(robot_frame(6, lamp_body(40)), golden[6] + "\n");
  EXPECT_EQ(robot_frame(7, "FIND"), golden[7] + "\n");
  EXPECT_EQ(robot_frame(8, name_body(253, 1)), golden[8] + "\n");
  EXPECT_EQ(robot_frame(9, middle_body(1)), golden[9] + "\n");
}

TEST(RobotLines, GoldenLinesFromTheRobotAreUnderstood) {
  const std::vector<std::string> golden = golden_lines("robot");
  ASSERT_EQ(golden.size(), 14U);
  const auto ready = said<ReadyLine>(golden[0]);
  EXPECT_EQ(ready.protocol, 1);
  EXPECT_EQ(ready.firmware, "1.1.0");
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
  EXPECT_EQ(said<AnswerLine>(golden[8]).refusal, "HEAT");
  EXPECT_EQ(said<LampLine>(golden[9]).lamp, (LampState{.percent = 40, .celsius = 31.4, .too_hot = false}));
  EXPECT_EQ(said<LampLine>(golden[10]).lamp, (LampState{.percent = 0, .celsius = 62.5, .too_hot = true}));
  EXPECT_FALSE(said<LampLine>(golden[11]).lamp.has_value());
  EXPECT_EQ(said<FoundLine>(golden[12]).ids, (std::vector{1, 253}));
  EXPECT_TRUE(said<FoundLine>(golden[13]).ids.empty());
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

std::string framed(const std::string& body) {
  boost::crc_optimal<16, 0x1021, 0xFFFF, 0, false, false> crc;
  crc.process_bytes(body.data(), body.size());
  return fmt::format("${}*{:04X}", body, crc.checksum());
}

TEST(RobotLines, WhatTheProtocolDoesNotAllowSaysNothingWhateverItsChecksum) {
  ASSERT_TRUE(parse_robot_line(framed("POS 5 -89.95 250 179.99 0 HOLD")));
  ASSERT_TRUE(parse_robot_line(framed("READY 1 1.0.0 -45 45.5 -90 9 90")));
  for (const char* const body : {"POS 5 nan 3 0.00 3 HOLD",
                                 "POS 5 inf 3 0.00 3 HOLD",
                                 "POS 5 1e308 3 0.00 3 HOLD",
                                 "POS 5 1e1 3 0.00 3 HOLD",
                                 "POS 5 180.01 3 0.00 3 HOLD",
                                 "POS 5 0x10 3 0.00 3 HOLD",
                                 "POS 5 +1.00 3 0.00 3 HOLD",
                                 "POS 5 1.000 3 0.00 3 HOLD",
                                 "POS 5 . 3 0.00 3 HOLD",
                                 "POS 5 - 3 0.00 3 HOLD",
                                 "POS 5 1.00 -3 0.00 3 HOLD",
                                 "POS 5 1.00 -1e8 0.00 3 HOLD",
                                 "POS 5 1.00 251 0.00 3 HOLD",
                                 "POS 5 1.00 nan 0.00 3 HOLD",
                                 "POS 4294967296 1.00 3 0.00 3 HOLD",
                                 "POS x 1.00 3 0.00 3 HOLD",
                                 "POS 5 1.00 3 0.00 3 DANCE",
                                 "READY 1 1.0.0 -1000000 1000000 -90 9 90",
                                 "FOUND 254",
                                 "FOUND 2 1",
                                 "FOUND 1 1",
                                 "FOUND -1",
                                 "FOUND 1 2 3 4 5 6 7 8 9",
                                 "FOUND x",
                                 "LAMP 101 25.0 COOL",
                                 "LAMP -1 25.0 COOL",
                                 "LAMP 40 25.0 WARM",
                                 "LAMP 40 nan COOL",
                                 "LAMP 40 101.0 HOT",
                                 "LAMP 40 - COOL",
                                 "LAMP 40 25.0 NONE",
                                 "LAMP 40 25.0",
                                 "READY 1 1.0.0 -inf inf -90 9 90",
                                 "READY 1 1.0.0 nan nan -90 9 90",
                                 "READY 1 1.0.0 -90 90 -90 9.01 90",
                                 "READY 1 1.0.0 90 -90 -90 9 90",
                                 "READY 1 1.0.0 10 10 -90 9 90",
                                 "READY 1 1.0.0 -90 90 -90 9 1e3",
                                 "READY -1 1.0.0 -90 90 -90 9 90",
                                 "ACK 256",
                                 "ACK -1",
                                 "ACK 1e1",
                                 "NAK 7 \x1b[2J",
                                 "NAK 7 limit",
                                 "NAK 7 \xff",
                                 "STAT ROLL 00 42 12.0 140"})
    EXPECT_FALSE(parse_robot_line(framed(body))) << body;
  EXPECT_FALSE(parse_robot_line(framed("NAK 7 " + std::string(60, 'A')))) << "longer than a frame";
  for (const char* const line : {"1e9x-29.90", "999.99x0.00", "-inf.00x0.00"})
    EXPECT_FALSE(parse_robot_line(line)) << line;
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
