#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <vector>

#include "tests/firmware/firmware_fixture.hpp"

namespace rva::test {
namespace {

using testing::AllOf;
using testing::Each;
using testing::Ge;
using testing::HasSubstr;
using testing::Le;
using testing::Not;
using testing::StartsWith;

constexpr double near_deg = 0.7;  // two counts

struct Positions {
  double pan_deg;
  double tilt_deg;
};

// Of bare lines and of frames; those without both angles say nothing.
std::vector<Positions> positions_in(const std::vector<std::string>& lines) {
  std::vector<Positions> all;
  for (const std::string& line : lines) {
    Positions one{};
    unsigned time = 0;
    int age = 0;
    if (std::sscanf(line.c_str(), "$POS %u %lf %d %lf", &time, &one.pan_deg, &age, &one.tilt_deg) == 4 ||
        std::sscanf(line.c_str(), "%lfx%lf", &one.pan_deg, &one.tilt_deg) == 2)
      all.push_back(one);
  }
  return all;
}

std::string last_state(Board& board) {
  board.take_lines();
  board.run_ms(60);
  std::string state;
  for (const std::string& line : board.take_lines()) {
    if (!line.starts_with("$POS")) continue;
    const std::size_t end = line.find('*');
    const std::size_t begin = line.rfind(' ', end) + 1;
    state = line.substr(begin, end - begin);
  }
  return state;
}

void expect_within_limits(const Board& board) {
  const Board::Extremes& extremes = board.extremes();
  EXPECT_LE(extremes.fastest_deg_s, 90.0 + 1e-6);
  EXPECT_THAT(extremes.pan_low_deg, Ge(-90.2)) << "half a count beyond";
  EXPECT_THAT(extremes.pan_high_deg, Le(90.2));
  EXPECT_THAT(extremes.tilt_low_deg, Ge(-90.2));
  EXPECT_THAT(extremes.tilt_high_deg, Le(9.2));
}

TEST_P(FirmwareTest, SaysWhichRobotItIsAndWhereItStands) {
  Board robot = board({12.0, -30.0, true});
  ASSERT_TRUE(robot.run_until_ready());
  robot.run_ms(200);
  const std::vector<std::string> lines = robot.take_lines();
  ASSERT_FALSE(lines.empty());
  EXPECT_EQ(lines.front(), "$READY 1 1.1.0 -90 90 -90 9 90*9229");
  const std::vector<Positions> positions = positions_in(lines);
  ASSERT_GT(positions.size(), 5U);
  EXPECT_NEAR(positions.back().pan_deg, 12.0, 0.2);
  EXPECT_NEAR(positions.back().tilt_deg, -30.0, 0.2);
  EXPECT_EQ(lines.back(), "12.03x-29.90") << "two decimals, as hosts of the thesis expect";
}

TEST_P(FirmwareTest, HoldsWhatLiesFreeWithoutAJump) {
  for (const bool torque : {false, true}) {
    Board robot = board({40.0, -50.0, torque});
    ASSERT_TRUE(robot.run_until_ready());
    const double pan_deg = robot.pan().angle_deg();
    robot.forget_extremes();
    robot.run_ms(1000);
    EXPECT_TRUE(robot.pan().torque() && robot.tilt().torque());
    EXPECT_LT(robot.extremes().fastest_deg_s, 0.01) << "no jump, no sag";
    EXPECT_NEAR(robot.pan().angle_deg(), pan_deg, 1e-9);
    if (torque) {
      EXPECT_NEAR(pan_deg, 40.0, 1e-9) << "not let go for a moment";
    }
  }
}

TEST_P(FirmwareTest, StopsWhatWasUnderWayWhenItIsReset) {
  Board robot = board({-80.0, -10.0, true});
  ASSERT_TRUE(robot.run_until_ready());
  robot.send("80.");
  robot.run_ms(500);
  ASSERT_TRUE(robot.pan().moving());
  robot.reset(another());
  robot.run_ms(100);
  EXPECT_FALSE(robot.pan().moving());
  const double pan_deg = robot.pan().angle_deg();
  robot.run_ms(1000);
  EXPECT_NEAR(robot.pan().angle_deg(), pan_deg, 0.01);
  EXPECT_TRUE(robot.pan().torque());
}

TEST_P(FirmwareTest, ObeysFramesAndAnswersThem) {
  Board robot = board();
  ASSERT_TRUE(robot.run_until_ready());
  const int number = robot.send_frame("MOVE 45.50 -10.25");
  EXPECT_EQ(robot.answer(number), fmt::format("ACK {}", number));
  EXPECT_EQ(last_state(robot), "MOVE");
  run_in_sight_ms(robot, 1500);
  EXPECT_NEAR(robot.pan().angle_deg(), 45.5, 0.2);
  EXPECT_NEAR(robot.tilt().angle_deg(), -10.25, 0.2);
  EXPECT_EQ(last_state(robot), "HOLD");
  EXPECT_GT(robot.extremes().fastest_deg_s, 75.0) << "as fast as it may";
  expect_within_limits(robot);
  for (const auto& [body, reason] :
       {std::pair{"MOVE 45 9.1", "LIMIT"}, {"MOVE 45", "FORM"}, {"JUMP", "FORM"}}) {
    const int refused = robot.send_frame(body);
    EXPECT_EQ(robot.answer(refused), fmt::format("NAK {} {}", refused, reason));
  }
  run_in_sight_ms(robot, 300);
  EXPECT_NEAR(robot.pan().angle_deg(), 45.5, 0.2);
}

TEST_P(FirmwareTest, ACommandReachesTheServosWithin20Ms) {
  Board robot = board();
  ASSERT_TRUE(robot.run_until_ready());
  for (const std::string bare : {"20.-5", ".-20"}) {
    robot.first_jog_ms = -1.0;
    const double sent_ms = robot.now_ms();
    robot.send(bare);
    robot.run_ms(50);
    EXPECT_LT(robot.first_jog_ms - sent_ms, 20.0) << bare;
    EXPECT_GT(robot.first_jog_ms, sent_ms);
    robot.run_ms(1000);
  }
  robot.first_jog_ms = -1.0;
  const double sent_ms = robot.now_ms();
  robot.send_frame("MOVE 0 0");
  robot.run_ms(50);
  EXPECT_GT(robot.first_jog_ms, sent_ms);
  EXPECT_LT(robot.first_jog_ms - sent_ms, 20.0);
}

TEST_P(FirmwareTest, ObeysBareAnglesAsTheThesisHasThem) {
  Board robot = board();
  ASSERT_TRUE(robot.run_until_ready());
  robot.send("45.-10");
  robot.run_ms(1500);
  EXPECT_NEAR(robot.pan().angle_deg(), 45.0, 0.2) << "without a watchdog: such a host sends it once";
  EXPECT_NEAR(robot.tilt().angle_deg(), -10.0, 0.2);
  robot.send(".-40");
  robot.run_ms(1500);
  EXPECT_NEAR(robot.pan().angle_deg(), 45.0, 0.2);
  EXPECT_NEAR(robot.tilt().angle_deg(), -40.0, 0.2);
  for (const std::string junk : {"hello", "\n", "20.5.-10.5", "45.10", "91.0"}) {
    robot.send(junk);
    robot.run_ms(300);
  }
  robot.send("50.");
  robot.run_ms(20);
  robot.send("5");
  robot.run_ms(1000);
  EXPECT_NEAR(robot.pan().angle_deg(), 50.0, 0.2);
  EXPECT_NEAR(robot.tilt().angle_deg(), -40.0, 0.2);
  robot.send("45.120.-20");
  robot.run_ms(2000);
  EXPECT_NEAR(robot.pan().angle_deg(), 20.0, 0.2) << "two run together: the second is not lost";
  EXPECT_NEAR(robot.tilt().angle_deg(), -20.0, 0.2);
  expect_within_limits(robot);
}

TEST_P(FirmwareTest, HoldsWhenTheHostFallsSilent) {
  Board robot = board({-80.0, 0.0, true});
  ASSERT_TRUE(robot.run_until_ready());
  robot.send_frame("MOVE 80 0 40");
  robot.run_ms(700);
  const double pan_deg = robot.pan().angle_deg();
  EXPECT_LT(pan_deg, -80.0 + 0.56 * 40.0) << "half a second and what it takes to tell the servo";
  EXPECT_GT(pan_deg, -80.0 + 0.2 * 40.0);
  robot.run_ms(2000);
  EXPECT_NEAR(robot.pan().angle_deg(), pan_deg, 0.01);
  EXPECT_EQ(last_state(robot), "LOST");
  robot.send_frame("MOVE 0 0");
  run_in_sight_ms(robot, 2500);
  EXPECT_NEAR(robot.pan().angle_deg(), 0.0, 0.2);
  EXPECT_EQ(last_state(robot), "HOLD");
}

TEST_P(FirmwareTest, StopsAtOnce) {
  for (const std::string stop : {"frame", "!", "in a frame"}) {
    Board robot = board({-80.0, -80.0, true});
    ASSERT_TRUE(robot.run_until_ready());
    robot.send_frame("MOVE 80 0");
    robot.run_ms(400);
    const double pan_deg = robot.pan().angle_deg();
    if (stop == "frame")
      robot.send_frame("STOP");
    else
      robot.send(stop == "!" ? "!" : "$12 MOVE 3!0 ");
    run_in_sight_ms(robot, 1000);
    EXPECT_LT(robot.pan().angle_deg() - pan_deg, 90.0 * 0.020) << stop;
    EXPECT_FALSE(robot.pan().moving() || robot.tilt().moving());
    EXPECT_EQ(last_state(robot), "HOLD");
  }
}

TEST_P(FirmwareTest, IsNeverFasterThanAskedHoweverTargetsChange) {
  Board robot = board();
  ASSERT_TRUE(robot.run_until_ready());
  std::mt19937 random(3);
  const auto between = [&](int low, int high) { return std::uniform_int_distribution(low, high)(random); };
  const int commands = GetParam() == Kind::native ? 3000 : 60;
  for (int i = 0; i < commands; ++i) {
    robot.send_frame(fmt::format("MOVE {}.{:02} {}.{:02}", between(-89, 89), between(0, 99), between(-89, 8),
                                 between(0, 99)));
    robot.run_ms(between(10, 400));
  }
  expect_within_limits(robot);
}

TEST_P(FirmwareTest, GoesSlowlyInPieces) {
  Board robot = board({-20.0, -20.0, true});
  ASSERT_TRUE(robot.run_until_ready());
  robot.send_frame("MOVE 20 -19 10");
  run_in_sight_ms(robot, 7000);
  EXPECT_NEAR(robot.pan().angle_deg(), 20.0, 0.4);
  EXPECT_NEAR(robot.tilt().angle_deg(), -19.0, 0.4);
  EXPECT_LE(robot.extremes().fastest_deg_s, 10.5) << "two counts of rounding";
}

TEST_P(FirmwareTest, LostRepliesAreNoAngles) {
  Board robot = board({30.0, -30.0, true}, 9);
  for (SimulatedServo* servo : {&robot.pan(), &robot.tilt()}) servo->faults.reply_lost = 1.0 / 3.0;
  ASSERT_TRUE(robot.run_until_ready());
  robot.take_lines();
  robot.send_frame("MOVE -60 -80");
  run_in_sight_ms(robot, 3000);
  EXPECT_NEAR(robot.pan().angle_deg(), -60.0, 0.2) << "the motion completes";
  EXPECT_NEAR(robot.tilt().angle_deg(), -80.0, 0.2);
  for (const Positions& reported : positions_in(robot.take_lines())) {
    EXPECT_THAT(reported.pan_deg, AllOf(Ge(-60.5), Le(30.5)));
    EXPECT_THAT(reported.tilt_deg, AllOf(Ge(-80.5), Le(-29.5)));
  }
  EXPECT_LT(robot.extremes().longest_silence_ms, 100.0);
}

TEST_P(FirmwareTest, WhatAServoDidNotHearIsSaidAgain) {
  Board robot = board({30.0, -30.0, true}, 2);
  for (SimulatedServo* servo : {&robot.pan(), &robot.tilt()}) servo->faults.packet_lost = 1.0 / 3.0;
  ASSERT_TRUE(robot.run_until_ready());
  for (const double pan_deg : {-10.0, 20.0, -20.0, 0.0, 10.0, -5.0}) {
    while (!robot.answer(robot.send_frame(fmt::format("MOVE {} -40", pan_deg))).starts_with("ACK")) continue;
    run_in_sight_ms(robot, 3000);
    EXPECT_NEAR(robot.pan().angle_deg(), pan_deg, 0.2);
  }
  robot.send_frame("MOVE 85 -40 20");
  run_in_sight_ms(robot, 1000);
  robot.send("!");
  run_in_sight_ms(robot, 1000);
  EXPECT_FALSE(robot.pan().moving()) << "stops too";
  EXPECT_LT(robot.pan().angle_deg(), 30.0);
}

TEST_P(FirmwareTest, NothingIsHeldWhereNobodyKnowsItIs) {
  Board robot = board({30.0, -30.0, false});
  robot.pan().faults.reply_lost = 1.0;
  robot.run_ms(1000);
  EXPECT_FALSE(robot.pan().torque());
  EXPECT_TRUE(robot.tilt().torque());
}

TEST_P(FirmwareTest, AServoThatDoesNotAnswerHasNoAngleAndIsNotMoved) {
  Board robot = board();
  ASSERT_TRUE(robot.run_until_ready());
  robot.send_frame("PING");
  robot.run_ms(100);
  robot.tilt().faults.reply_lost = 1.0;
  robot.run_ms(400);
  robot.take_lines();
  robot.run_ms(200);
  const std::vector<std::string> lines = robot.take_lines();
  EXPECT_TRUE(positions_in(lines).empty());
  EXPECT_THAT(lines, testing::Contains(HasSubstr(" - - START*")));
  EXPECT_THAT(robot.answer(robot.send_frame("MOVE 10 -10")), HasSubstr("BLIND"));
  robot.tilt().faults.reply_lost = 0.0;
  robot.run_ms(100);
  EXPECT_THAT(robot.answer(robot.send_frame("MOVE 10 -10")), StartsWith("ACK"));
}

TEST_P(FirmwareTest, UndocumentedBitsAndFlippedOnesAreNoAngles) {
  Board robot = board({30.0, -30.0, true}, 4);
  for (SimulatedServo* servo : {&robot.pan(), &robot.tilt()}) {
    servo->faults.high_bits = 0x64;
    servo->faults.bit_flipped = 0.01;
  }
  ASSERT_TRUE(robot.run_until_ready());
  robot.take_lines();
  run_in_sight_ms(robot, GetParam() == Kind::native ? 60000 : 5000);
  std::size_t reports = 0;
  const std::vector<std::string> lines = robot.take_lines();
  EXPECT_THAT(lines, Each(Not(HasSubstr("FAULT")))) << "nor faults";
  for (const Positions& one : positions_in(lines)) {
    ++reports;
    EXPECT_NEAR(one.pan_deg, 30.0, 2.2) << "a flip of the lowest bits is within what a push would do";
    EXPECT_NEAR(one.tilt_deg, -30.0, 2.2);
  }
  EXPECT_GT(reports, 100U);
  EXPECT_LT(robot.extremes().fastest_deg_s, 0.01);
}

TEST_P(FirmwareTest, RecoversFromAFaultAndReportsIt) {
  Board robot = board({0.0, -40.0, true});
  ASSERT_TRUE(robot.run_until_ready());
  robot.send_frame("MOVE 60 -40");
  run_in_sight_ms(robot, 300);
  robot.pan().faults.error = 0x04;  // too hot
  run_in_sight_ms(robot, 1000);
  EXPECT_EQ(last_state(robot), "FAULT");
  EXPECT_THAT(robot.answer(robot.send_frame("MOVE 0 0")), HasSubstr("FAULT"));
  robot.take_lines();
  robot.run_ms(600);
  EXPECT_THAT(robot.take_lines(), testing::Contains(StartsWith("$STAT PAN 04")));
  robot.pan().faults.error = 0;
  robot.run_ms(1200);
  EXPECT_TRUE(robot.pan().torque());
  EXPECT_EQ(last_state(robot), "HOLD");
  const double pan_deg = robot.pan().angle_deg();
  robot.run_ms(1000);
  EXPECT_NEAR(robot.pan().angle_deg(), pan_deg, 0.01) << "the target of before is given up";
  EXPECT_THAT(robot.answer(robot.send_frame("MOVE 0 0")), StartsWith("ACK"));
  run_in_sight_ms(robot, 2500);
  EXPECT_NEAR(robot.pan().angle_deg(), 0.0, 0.2);
}

TEST_P(FirmwareTest, AMillionHostileBytesDoNoHarm) {
  Board robot = board();
  ASSERT_TRUE(robot.run_until_ready());
  robot.forget_extremes();
  std::mt19937 random(11);
  const std::string likely = "0123456789.-$* MOVESTPINGCLEA\n";
  const int bursts = GetParam() == Kind::native ? 1000 : 30;
  for (int burst = 0; burst < bursts; ++burst) {
    std::string bytes;
    for (int i = 0; i < 1000; ++i)
      bytes += burst % 2 == 0 ? static_cast<char>(random()) : likely[random() % likely.size()];
    robot.send(bytes);
    robot.run_ms(100);
    robot.run_ms(burst % 10 == 0 ? 30 : 0);
  }
  expect_within_limits(robot);
  EXPECT_LT(robot.extremes().longest_silence_ms, 100.0);
  robot.run_ms(50);
  EXPECT_THAT(robot.answer(robot.send_frame("MOVE 33 -3")), StartsWith("ACK"));
  run_in_sight_ms(robot, 3000);
  EXPECT_NEAR(robot.pan().angle_deg(), 33.0, 0.2);
}

TEST_P(FirmwareTest, NoiseOnTheHostsLineIsRefusedAndRepeatsGetThrough) {
  Board robot = board({}, 8);
  ASSERT_TRUE(robot.run_until_ready());
  robot.host_bit_flipped = 0.01;
  const int frames = GetParam() == Kind::native ? 1000 : 100;
  int taken = 0;
  for (int i = 0; i < frames; ++i)
    taken += robot.answer(robot.send_frame("MOVE 10 -10")).starts_with("ACK") ? 1 : 0;
  EXPECT_GT(taken, 0.65 * frames) << "21 bytes at one flip in a hundred: four of five arrive";
  EXPECT_LT(taken, 0.95 * frames);
  expect_within_limits(robot);
  EXPECT_NEAR(robot.pan().angle_deg(), 10.0, 0.2);
}
INSTANTIATE_TEST_SUITE_P(Logic, FirmwareTest, testing::Values(Kind::native));
INSTANTIATE_TEST_SUITE_P(Board, FirmwareTest, testing::Values(Kind::board));

TEST(Firmware, LeavesMostOfTheBoardFree) {
  const std::optional<BuiltSize> size = built_size();
  if (!size) GTEST_SKIP() << "the board's program was not built";
  EXPECT_LT(size->flash_bytes, 32U * 1024U);
  EXPECT_LT(size->memory_bytes, 4U * 1024U);
  EXPECT_GT(size->memory_bytes, 100U);
}

TEST(Firmware, ItsClockMayRunOver) {
  Board robot(native_firmware(0xFFFFFFFFU - 1500), {0.0, 0.0, true});
  ASSERT_TRUE(robot.run_until_ready());
  const int number = robot.send_frame("MOVE 45 -10");
  EXPECT_EQ(robot.answer(number), fmt::format("ACK {}", number));
  for (int i = 0; i < 30; ++i) {
    robot.send_frame("PING");
    robot.run_ms(100);
  }
  EXPECT_NEAR(robot.pan().angle_deg(), 45.0, near_deg);
  EXPECT_LT(robot.extremes().longest_silence_ms, 100.0);
}

}  // namespace
}  // namespace rva::test
