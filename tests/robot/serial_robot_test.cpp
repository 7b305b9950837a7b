#include "robot/serial_robot.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <optional>

#include "core/error.hpp"
#include "tests/eventually.hpp"
#include "tests/firmware/pty_board.hpp"
#include "tests/temporary_folder.hpp"

namespace rva {
namespace {

using test::Board;
using test::eventually;
using test::Firmware;
using test::PtyBoard;
using test::TemporaryFolder;
using testing::HasSubstr;

/// The thesis' sketch, as far as a host sees it: whole degrees, no answer, positions every 26 ms.
class ThesisFirmware : public Firmware {
 public:
  void from_host(std::uint8_t byte) override {
    text_.push_back(static_cast<char>(byte));
    quiet_steps_ = 0;
  }
  void from_servos(std::uint8_t /*byte*/) override {}
  void step() override {
    if (++quiet_steps_ == 20 && !text_.empty()) obey();
    for (int axis = 0; axis < 2; ++axis) {
      constexpr double deg_a_step = 0.009;
      const double left_deg = target_deg_[axis] - deg_[axis];
      deg_[axis] += std::clamp(left_deg, -deg_a_step, deg_a_step);
    }
    if (++steps_ % 260 != 0) return;
    for (const char character : fmt::format("{:.2f}x{:.2f}\r\n", deg_[0], deg_[1]))
      to_host.push_back(static_cast<std::uint8_t>(character));
  }

 private:
  void obey() {
    const std::size_t point = text_.find('.');
    const std::string halves[] = {text_.substr(0, point),
                                  point == std::string::npos ? "" : text_.substr(point + 1)};
    for (int axis = 0; axis < 2; ++axis) {
      if (!halves[axis].empty()) target_deg_[axis] = std::atoi(halves[axis].c_str());
    }
    text_.clear();
  }

  std::string text_;
  int quiet_steps_ = 0;
  long steps_ = 0;
  double deg_[2] = {0.0, -10.0};
  double target_deg_[2] = {0.0, -10.0};
};

/// Something else on the line.
class OtherDevice : public Firmware {
 public:
  explicit OtherDevice(std::string text) : text_(std::move(text)) {}
  void from_host(std::uint8_t /*byte*/) override {}
  void from_servos(std::uint8_t /*byte*/) override {}
  void step() override {
    if (++steps_ % 500 == 0) to_host.insert(to_host.end(), text_.begin(), text_.end());
  }

 private:
  std::string text_;
  long steps_ = 0;
};

class SerialRobotTest : public testing::Test {
 protected:
  [[nodiscard]] std::string terminal() const { return (folder_.path() / "robot").string(); }
  PtyBoard board(Board::Start start = {0.0, -10.0, true}) const {
    return {terminal(), [] { return test::native_firmware(); }, start};
  }

  template <typename Work>
  static std::string error_of(const Work& work) {
    try {
      work();
    } catch (const Error& error) {
      return error.what();
    }
    return "no error";
  }

 private:
  TemporaryFolder folder_;
};

void expect_moves(Robot& robot, const PanTilt& target) {
  const PanTilt reached = move_and_wait(robot, target);
  EXPECT_NEAR(reached.pan_deg, target.pan_deg, 0.4);
  EXPECT_NEAR(reached.tilt_deg, target.tilt_deg, 0.4);
  EXPECT_FALSE(robot.moving());
}

TEST_F(SerialRobotTest, RecognisesOurFirmwareAndMovesIt) {
  PtyBoard board = this->board();
  SerialRobot robot(terminal());
  EXPECT_EQ(robot.kind(), RobotKind::framed);
  EXPECT_EQ(robot.firmware(), "1.1.0");
  EXPECT_EQ(robot.limits(), RobotLimits{});
  EXPECT_NEAR(robot.joints().tilt_deg, -10.0, 0.2);
  expect_moves(robot, {70.0, -60.0});
  board.with_board([](Board& there) { EXPECT_NEAR(there.pan().angle_deg(), 70.0, 0.2); });
  EXPECT_THROW(robot.move_to({91.0, 0.0}), UsageError);
  EXPECT_NEAR(robot.joints().pan_deg, 70.0, 0.4);
}

TEST_F(SerialRobotTest, MovesTheBuiltProgramOnASimulatedBoard) {
  if (!test::simulated_board()) GTEST_SKIP() << "the board's program was not built";
  const PtyBoard board(terminal(), [] { return test::simulated_board(); });
  SerialRobot robot(terminal());
  EXPECT_EQ(robot.kind(), RobotKind::framed);
  expect_moves(robot, {-40.0, -45.0});
}

TEST_F(SerialRobotTest, SwitchesTheLamp) {
  PtyBoard board = this->board();
  SerialRobot robot(terminal());
  ASSERT_TRUE(eventually([&] { return robot.lamp().has_value(); }));
  EXPECT_EQ(robot.lamp()->percent, 0);
  robot.set_lamp(60);
  std::this_thread::sleep_for(std::chrono::milliseconds(700));
  board.with_board(
      [](Board& there) { EXPECT_NEAR(there.lamp(), 0.6, 0.01) << "a silent host switches it off"; });
  EXPECT_EQ(robot.lamp()->percent, 60);
  EXPECT_NEAR(robot.lamp()->celsius.value(), 25.0, 0.5);
  EXPECT_THROW(robot.set_lamp(101), UsageError);
  EXPECT_THROW(robot.set_lamp(-1), UsageError);
  board.with_board([](Board& there) { there.lamp_celsius = 70.0; });
  ASSERT_TRUE(eventually([&] { return robot.lamp()->too_hot; }));
  EXPECT_EQ(robot.lamp()->percent, 0);
  EXPECT_THAT(error_of([&] { robot.set_lamp(60); }), HasSubstr("too hot"));
  board.with_board([](Board& there) { there.lamp_celsius.reset(); });
  ASSERT_TRUE(eventually([&] { return !robot.lamp(); })) << "without a thermistor there is no lamp";
  EXPECT_THAT(error_of([&] { robot.set_lamp(60); }), HasSubstr("has no lamp"));
}

TEST_F(SerialRobotTest, TheLampGoesOutWithTheProgram) {
  PtyBoard board = this->board();
  {
    SerialRobot robot(terminal());
    ASSERT_TRUE(eventually([&] { return robot.lamp().has_value(); }));
    robot.set_lamp(100);
    board.with_board([](Board& there) { EXPECT_EQ(there.lamp(), 1.0); });
  }
  EXPECT_TRUE(eventually([&] {
    double lamp = 1.0;
    board.with_board([&](Board& there) { lamp = there.lamp(); });
    return lamp == 0.0;
  }));
}

TEST_F(SerialRobotTest, RecognisesTheThesisFirmwareAndMovesIt) {
  const PtyBoard board(terminal(), [] { return std::make_unique<ThesisFirmware>(); });
  SerialRobot robot(terminal());
  EXPECT_EQ(robot.kind(), RobotKind::bare);
  EXPECT_EQ(robot.firmware(), "");
  EXPECT_FALSE(robot.lamp());
  EXPECT_THAT(error_of([&] { robot.set_lamp(10); }), HasSubstr("has no lamp"));
  expect_moves(robot, {30.0, -20.0});
  robot.move_to({-80.0, -20.0});
  ASSERT_TRUE(eventually([&] { return robot.joints().pan_deg < 28.0; }));
  EXPECT_TRUE(robot.moving());
  robot.stop();
  ASSERT_TRUE(eventually([&] { return !robot.moving(); }));
  EXPECT_GT(robot.joints().pan_deg, -70.0);
}

TEST_F(SerialRobotTest, StopsOnItsWay) {
  PtyBoard board = this->board();
  SerialRobot robot(terminal());
  robot.move_to({-90.0, -10.0});
  ASSERT_TRUE(eventually([&] { return robot.joints().pan_deg <= -10.0; }));
  EXPECT_TRUE(robot.moving());
  robot.stop();
  ASSERT_TRUE(eventually([&] { return !robot.moving(); }));
  EXPECT_GT(robot.joints().pan_deg, -60.0);
}

TEST_F(SerialRobotTest, IsFoundAgainWhenItWasUnpluggedAndSaysSoMeanwhile) {
  PtyBoard board = this->board();
  SerialRobot robot(terminal());
  for (int i = 0; i < 2; ++i) {
    board.unplug();
    ASSERT_TRUE(eventually([&] { return robot.kind() == RobotKind::unknown; }));
    EXPECT_THAT(error_of([&] { (void)robot.joints(); }), HasSubstr("the robot is disconnected"));
    EXPECT_THAT(error_of([&] { robot.move_to({10.0, -10.0}); }), HasSubstr("the robot is disconnected"));
    board.plug_in();
    ASSERT_TRUE(eventually([&] { return robot.kind() != RobotKind::unknown; }));
    ASSERT_TRUE(eventually([&] { return error_of([&] { (void)robot.joints(); }) == "no error"; }));
    expect_moves(robot, {20.0 - 10.0 * i, -20.0});
  }
}

TEST_F(SerialRobotTest, NoiseOnTheLineCostsRepeatsOnly) {
  PtyBoard board = this->board();
  SerialRobot robot(terminal());
  board.with_board([](Board& there) {
    there.host_bit_flipped = 0.005;
    there.pan().faults.reply_lost = there.tilt().faults.reply_lost = 0.2;
  });
  for (const double pan_deg : {20.0, -20.0, 0.0}) expect_moves(robot, {pan_deg, -30.0});
}

TEST_F(SerialRobotTest, FaultsAndBlindnessAreReported) {
  PtyBoard board = this->board();
  SerialRobot robot(terminal());
  expect_moves(robot, {5.0, -10.0});
  board.with_board([](Board& there) { there.pan().faults.error = 0x10; });
  ASSERT_TRUE(eventually([&] { return error_of([&] { (void)robot.moving(); }) != "no error"; }));
  EXPECT_THAT(error_of([&] { robot.move_to({10.0, -10.0}); }), HasSubstr("a servo is at fault"));
  EXPECT_THAT(error_of([&] { (void)robot.moving(); }), HasSubstr("a servo is at fault"));
  board.with_board([](Board& there) {
    there.pan().faults.error = 0;
    there.pan().faults.reply_lost = 1.0;
  });
  EXPECT_TRUE(eventually([&] {
    return error_of([&] { (void)robot.joints(); }).find("the joint angles are unknown") != std::string::npos;
  }));
}

TEST_F(SerialRobotTest, SaysWhatIsWrongWithADevice) {
  const auto open = [](const std::string& path) { return error_of([&] { const SerialRobot robot(path); }); };
  EXPECT_THAT(open(terminal()), HasSubstr("no such device"));
  std::ofstream(terminal()) << "no device";
  EXPECT_THAT(open(terminal()), HasSubstr("not a serial port"));
}

TEST_F(SerialRobotTest, TheDeviceIsNobodyElsesMeanwhile) {
  const PtyBoard board = this->board();
  SerialRobot robot(terminal());
  EXPECT_THAT(error_of([&] { const SerialRobot other(terminal()); }), HasSubstr("another program uses it"));
  expect_moves(robot, {10.0, -20.0});
}

TEST_F(SerialRobotTest, OtherDevicesAreNoRobots) {
  for (const auto& [text, problem] : {std::pair{"", "no data is received"},
                                      {"GPS $GPGGA,123519*47\r\n", "does not respond like a robot"},
                                      {"endless noise without an end ", "does not respond like a robot"}}) {
    const PtyBoard board(terminal(), [text = text] { return std::make_unique<OtherDevice>(text); });
    EXPECT_THAT(error_of([&] { const SerialRobot robot(terminal()); }), HasSubstr(problem)) << text;
  }
}

}  // namespace
}  // namespace rva
