#include "robot/servo_setup.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <string>

#include "core/error.hpp"
#include "tests/eventually.hpp"
#include "tests/firmware/pty_board.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

using test::Board;
using test::PtyBoard;
using test::TemporaryFolder;
using testing::HasSubstr;
using testing::ThrowsMessage;

class ServoSetup : public testing::Test {
 protected:
  // With the servos that are connected, by their IDs.
  ServoSetup() : board_(terminal(), [] { return test::native_firmware(); }) {}

  [[nodiscard]] std::string terminal() const { return (folder_.path() / "robot").string(); }

  void connect(bool pan, bool tilt) {
    board_.with_board([&](Board& there) {
      there.pan().faults.packet_lost = pan ? 0.0 : 1.0;
      there.tilt().faults.packet_lost = tilt ? 0.0 : 1.0;
    });
  }
  void deliver() {
    board_.with_board([](Board& there) {
      there.pan().set_id(253);
      there.tilt().set_id(253);
    });
  }
  int id_of_pan() {
    int id = 0;
    board_.with_board([&](Board& there) { id = there.pan().id(); });
    return id;
  }

  TemporaryFolder folder_;
  PtyBoard board_;
};

bool can_move(SerialRobot& robot) {
  try {
    robot.move_to(robot.joints());
    return true;
  } catch (const Error&) {
    return false;
  }
}

TEST_F(ServoSetup, NamesOneAfterTheOtherUntilTheRobotMoves) {
  deliver();
  connect(true, false);
  SerialRobot robot(terminal());
  EXPECT_EQ(set_up_servo(robot, ServoJoint::pan), 253);
  EXPECT_EQ(id_of_pan(), 1);
  EXPECT_EQ(set_up_servo(robot, ServoJoint::pan), 1) << "a second time changes nothing";
  robot.turn_to_middle(1);
  connect(false, true);
  EXPECT_EQ(set_up_servo(robot, ServoJoint::tilt), 253);
  connect(true, true);
  EXPECT_EQ(robot.find_servos(), (std::vector{1, 2}));
  ASSERT_TRUE(test::eventually([&] { return can_move(robot); })) << "both are held";
  const PanTilt reached = move_and_wait(robot, {20.0, -30.0});
  EXPECT_NEAR(reached.pan_deg, 20.0, 0.4);
}

TEST_F(ServoSetup, RefusesToGuess) {
  SerialRobot robot(terminal());
  EXPECT_THAT([&] { set_up_servo(robot, ServoJoint::pan); },
              ThrowsMessage<Error>(HasSubstr("several servos answer (IDs 1, 2)")));
  connect(false, false);
  EXPECT_THAT([&] { set_up_servo(robot, ServoJoint::tilt); },
              ThrowsMessage<Error>(HasSubstr("connect the tilt servo alone")));
  connect(true, true);
  EXPECT_EQ(id_of_pan(), 1);
  EXPECT_THROW(robot.name_servo(1, 254), UsageError);
}

}  // namespace
}  // namespace rva
