// The firmware's logic with simulated servos, over a pseudo terminal; and the simulated robot.
#include "doctor/robot_checkup.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "sim/simulated_robot.hpp"
#include "tests/doctor/items.hpp"
#include "tests/firmware/pty_board.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

using test::Board;
using test::item;
using test::state;
using testing::HasSubstr;

class BoardCheckup : public testing::Test {
 protected:
  BoardCheckup() : board_((folder_.path() / "robot").string(), [] { return test::native_firmware(); }) {}

  CheckedItems examine(bool may_move = false) {
    return examine_robot(
        [&]() -> OpenedRobot {
          auto robot = std::make_unique<SerialRobot>(board_.path());
          SerialRobot* const serial = robot.get();
          return {std::move(robot), serial};
        },
        may_move);
  }

  test::TemporaryFolder folder_;
  test::PtyBoard board_;
};

TEST_F(BoardCheckup, FindsNothingWrongWithASoundRobot) {
  const CheckedItems items = examine(true);
  for (const std::string& name : robot_check_names())
    EXPECT_EQ(state(items, name), "ok") << name << ": " << item(items, name).result;
  EXPECT_EQ(item(items, "robot-firmware").result, "1.1.0");
  EXPECT_THAT(item(items, "lamp").result, HasSubstr("can be switched, 25."));
  EXPECT_LT(item(items, "stop").values.at("overshoot_deg"), 20.0);
  board_.with_board([](Board& board) {
    EXPECT_NEAR(board.pan().angle_deg(), 0.0, 1.0) << "it is back where it was";
    EXPECT_EQ(board.lamp(), 0.0);
  });
}

TEST_F(BoardCheckup, DoesNotMoveUnasked) {
  board_.with_board([](Board& board) { board.first_jog_ms = -1.0; });
  const CheckedItems items = examine();
  EXPECT_EQ(state(items, "stop"), "not-tried");
  EXPECT_THAT(item(items, "stop").result, HasSubstr("--move"));
  board_.with_board([](Board& board) { EXPECT_NEAR(board.pan().angle_deg(), 0.0, 0.5); });
}

TEST_F(BoardCheckup, FindsADeadServo) {
  board_.with_board([](Board& board) { board.tilt().faults.packet_lost = 1.0; });
  const CheckedItems items = examine(true);
  EXPECT_EQ(state(items, "servos"), "failed");
  EXPECT_THAT(item(items, "servos").result,
              HasSubstr("the tilt servo does not answer (those with the IDs 1 do)"));
  EXPECT_EQ(state(items, "stop"), "not-tried");
  EXPECT_EQ(state(items, "lamp"), "ok") << "the lamp does not depend on the servos";
}

TEST_F(BoardCheckup, FindsALampThatIsHotOrCutOff) {
  board_.with_board([](Board& board) { board.lamp_celsius = 75.0; });
  EXPECT_EQ(state(examine(), "lamp"), "failed");
  board_.with_board([](Board& board) { board.lamp_celsius = std::nullopt; });
  EXPECT_EQ(state(examine(), "lamp"), "warning");
}

TEST(RobotCheckup, FindsNothingWrongWithASimulatedRobot) {
  const Clock clock = unhurried_clock();
  const CheckedItems items = examine_robot(
      [&]() -> OpenedRobot {
        return {std::make_unique<SimulatedRobot>(SimulatedRobotOptions{}, clock.now_s), nullptr};
      },
      true, clock);
  for (const char* const name : {"robot", "servos", "stop", "lamp"})
    EXPECT_EQ(state(items, name), "ok") << name << ": " << item(items, name).result;
  EXPECT_EQ(state(items, "robot-firmware"), "not-tried");
}

/// Goes on for a while after stop().
class SlowToStop : public SimulatedRobot {
 public:
  SlowToStop(std::function<double()> now_s, double late_s)
      : SimulatedRobot({.speed_deg_s = 30.0}, now_s), now_s_(std::move(now_s)), late_s_(late_s) {}
  void stop() override { asked_s_ = asked_s_ ? asked_s_ : now_s_(); }
  [[nodiscard]] PanTilt joints() override {
    if (asked_s_ && now_s_() - *asked_s_ >= late_s_) SimulatedRobot::stop();
    return SimulatedRobot::joints();
  }

 private:
  std::function<double()> now_s_;
  double late_s_;
  std::optional<double> asked_s_;
};

std::string state_of_stop(double late_s) {
  const Clock clock = unhurried_clock();
  return state(examine_robot(
                   [&]() -> OpenedRobot {
                     return {std::make_unique<SlowToStop>(clock.now_s, late_s), nullptr};
                   },
                   true, clock),
               "stop");
}

TEST(RobotCheckup, FindsARobotThatStopsLate) {
  EXPECT_EQ(state_of_stop(0.4), "warning");
  EXPECT_EQ(state_of_stop(0.6), "failed");
}

TEST(RobotCheckup, FindsOldFirmware) {
  EXPECT_EQ(robot_firmware_item(RobotKind::framed, "1.1.0").state, CheckState::ok);
  EXPECT_EQ(robot_firmware_item(RobotKind::framed, "1.10.0").state, CheckState::ok);
  for (const char* const old : {"1.0.9", "0.9", "?"})
    EXPECT_EQ(robot_firmware_item(RobotKind::framed, old).state, CheckState::warning) << old;
  EXPECT_THAT(robot_firmware_item(RobotKind::bare, "").result, HasSubstr("thesis"));
}

TEST(RobotCheckup, FailsWithTheReasonWhyItCannotBeOpened) {
  const CheckedItems items = examine_robot(
      []() -> OpenedRobot {
        return {std::make_unique<SerialRobot>("/dev/missing"), nullptr};
      },
      true);
  EXPECT_EQ(state(items, "robot"), "failed");
  EXPECT_THAT(item(items, "robot").result, HasSubstr("/dev/missing"));
  EXPECT_EQ(state(items, "lamp"), "not-tried");
}

}  // namespace
}  // namespace rva
