#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>
#include <string>

#include "tests/firmware/firmware_fixture.hpp"

namespace rva::test {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// The lamp, and servos before they are a robot's joints.
class PartsTest : public FirmwareTest {};

// The temperature is the mean of eight readings, 10 ms apart.
bool run_until_lamp_is_known(Board& board) {
  const bool ready = board.run_until_ready();
  board.run_ms(100);
  return ready;
}

std::string last_lamp_line(Board& board) {
  board.take_lines();
  board.send_frame("INFO");
  board.run_ms(100);
  std::string last;
  for (const std::string& line : board.take_lines())
    if (line.starts_with("$LAMP ")) last = line.substr(1, line.find('*') - 1);
  return last;
}

TEST_P(PartsTest, TheLampIsOffUntilItIsSwitchedOn) {
  Board robot = board();
  ASSERT_TRUE(run_until_lamp_is_known(robot));
  EXPECT_EQ(robot.lamp(), 0.0);
  EXPECT_THAT(last_lamp_line(robot), testing::MatchesRegex("LAMP 0 25\\.[01] COOL"));
  for (const int percent : {40, 100, 1, 0}) {
    const int number = robot.send_frame(fmt::format("LAMP {}", percent));
    EXPECT_EQ(robot.answer(number), fmt::format("ACK {}", number));
    EXPECT_NEAR(robot.lamp(), percent / 100.0, 0.5 / 255.0);
    EXPECT_THAT(last_lamp_line(robot), testing::MatchesRegex(fmt::format("LAMP {} 25\\.[01] COOL", percent)));
  }
  EXPECT_THAT(robot.answer(robot.send_frame("LAMP 101")), HasSubstr("LIMIT"));
}

TEST_P(PartsTest, TheLampGoesOutWhenTheHostFallsSilentOrTheBoardStartsAnew) {
  Board robot = board();
  ASSERT_TRUE(run_until_lamp_is_known(robot));
  robot.send_frame("LAMP 60");
  run_in_sight_ms(robot, 2000);
  robot.send("!");
  run_in_sight_ms(robot, 100);
  EXPECT_GT(robot.lamp(), 0.5) << "a stop leaves it on: somebody may have to see why";
  robot.run_ms(350);
  EXPECT_GT(robot.lamp(), 0.5);
  robot.run_ms(100);
  EXPECT_EQ(robot.lamp(), 0.0);
  robot.send_frame("PING");
  robot.run_ms(50);
  EXPECT_EQ(robot.lamp(), 0.0) << "it stays off until it is switched on";
  robot.send_frame("LAMP 60");
  robot.run_ms(50);
  robot.reset(another());
  robot.run_ms(50);
  EXPECT_EQ(robot.lamp(), 0.0);
}

TEST_P(PartsTest, ALampThatIsTooHotGoesOutUntilItIsCool) {
  Board robot = board();
  ASSERT_TRUE(run_until_lamp_is_known(robot));
  robot.send_frame("LAMP 100");
  robot.lamp_celsius = 59.0;
  run_in_sight_ms(robot, 300);
  EXPECT_EQ(robot.lamp(), 1.0);
  robot.lamp_celsius = 61.5;
  run_in_sight_ms(robot, 300);
  EXPECT_EQ(robot.lamp(), 0.0);
  EXPECT_THAT(last_lamp_line(robot), testing::MatchesRegex("LAMP 0 6[0-9]\\.[0-9] HOT"));
  robot.lamp_celsius = 52.0;
  run_in_sight_ms(robot, 300);
  EXPECT_THAT(robot.answer(robot.send_frame("LAMP 100")), HasSubstr("HEAT")) << "not yet cool";
  robot.lamp_celsius = 48.0;
  run_in_sight_ms(robot, 300);
  EXPECT_EQ(robot.lamp(), 0.0) << "it does not blink by itself";
  EXPECT_THAT(robot.answer(robot.send_frame("LAMP 100")), StartsWith("ACK"));
  EXPECT_EQ(robot.lamp(), 1.0);
}

TEST_P(PartsTest, ALampWhoseTemperatureIsNotKnownStaysOff) {
  Board robot = board();
  ASSERT_TRUE(run_until_lamp_is_known(robot));
  robot.send_frame("LAMP 80");
  run_in_sight_ms(robot, 100);
  EXPECT_GT(robot.lamp(), 0.5);
  for (const std::optional<double> celsius : {std::optional<double>(), std::optional<double>(300.0)}) {
    robot.lamp_celsius = celsius;
    run_in_sight_ms(robot, 300);
    EXPECT_EQ(robot.lamp(), 0.0);
    EXPECT_EQ(last_lamp_line(robot), "LAMP 0 - NONE");
    EXPECT_THAT(robot.answer(robot.send_frame("LAMP 1")), HasSubstr("HEAT"));
    EXPECT_THAT(robot.answer(robot.send_frame("LAMP 0")), StartsWith("ACK")) << "off is always allowed";
  }
}

// IDs as the robot reports them after FIND: "1 2".
std::string found_servos(Board& board) {
  board.send_frame("FIND");
  board.take_lines();
  std::string found = "no report";
  for (int i = 0; i < 30 && found == "no report"; ++i) {
    board.send_frame("PING");
    board.run_ms(100);
    for (const std::string& line : board.take_lines())
      if (line.starts_with("$FOUND")) found = line.substr(6, line.find('*') - 6);
  }
  return found;
}

TEST_P(PartsTest, FindsAndNamesServos) {
  Board robot = board();
  robot.pan().set_id(253);
  robot.tilt().faults.packet_lost = 1.0;
  robot.run_ms(500);
  EXPECT_EQ(found_servos(robot), " 253");
  EXPECT_THAT(robot.answer(robot.send_frame("NAME 253 1")), StartsWith("ACK"));
  run_in_sight_ms(robot, 300);
  EXPECT_EQ(robot.pan().id(), 1);
  EXPECT_EQ(found_servos(robot), " 1");
  robot.tilt().faults.packet_lost = 0.0;
  EXPECT_EQ(found_servos(robot), " 1 2");
  run_in_sight_ms(robot, 500);
  EXPECT_TRUE(robot.pan().torque()) << "both are held again";
  EXPECT_THAT(robot.answer(robot.send_frame("MOVE 10 -10")), StartsWith("ACK"));
  run_in_sight_ms(robot, 1000);
  EXPECT_NEAR(robot.pan().angle_deg(), 10.0, 0.4);
}

TEST_P(PartsTest, TurnsASingleServoToItsMiddleSlowly) {
  Board robot = board({-70.0, -30.0, false});
  robot.tilt().faults.packet_lost = 1.0;
  robot.run_ms(500);
  robot.forget_extremes();
  EXPECT_THAT(robot.answer(robot.send_frame("MOVE 0 0")), HasSubstr("BLIND")) << "one servo is no robot";
  EXPECT_THAT(robot.answer(robot.send_frame("MIDDLE 1")), StartsWith("ACK"));
  run_in_sight_ms(robot, 3200);
  EXPECT_NEAR(robot.pan().angle_deg(), 0.0, 0.2);
  EXPECT_TRUE(robot.pan().torque());
  EXPECT_LT(robot.extremes().fastest_deg_s, 45.0);
}

TEST_P(PartsTest, FindsNothingWhereNothingIsConnectedAndStopsAMove) {
  Board robot = board({-80.0, -10.0, true});
  ASSERT_TRUE(robot.run_until_ready());
  robot.send_frame("MOVE 80 -10 20");
  run_in_sight_ms(robot, 500);
  EXPECT_EQ(found_servos(robot), " 1 2");
  EXPECT_FALSE(robot.pan().moving());
  EXPECT_LT(robot.pan().angle_deg(), -60.0);
  for (SimulatedServo* servo : {&robot.pan(), &robot.tilt()}) servo->faults.packet_lost = 1.0;
  EXPECT_EQ(found_servos(robot), "");
}

INSTANTIATE_TEST_SUITE_P(Logic, PartsTest, testing::Values(Kind::native));
INSTANTIATE_TEST_SUITE_P(Board, PartsTest, testing::Values(Kind::board));

}  // namespace
}  // namespace rva::test
