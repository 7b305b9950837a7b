// Manual driving: the robot moves while a stick is held and stops when it is released.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "core/clock.hpp"
#include "core/options.hpp"
#include "robot/lamp.hpp"
#include "robot/robot.hpp"

namespace rva {

/// Options of manual driving.
struct DriveOptions {
  double speed_deg_s = 30.0;  ///< of a joint whose stick is held at its end
  int silence_ms = 250;       ///< time without a command after which the robot stops

  static void describe(auto&& self, auto&& visit) {
    visit(self.speed_deg_s,
          OptionField{"speed", "deg_s", 0.1, 90, "how fast a stick held at its end turns a joint"});
    visit(self.silence_ms,
          OptionField{"silence", "ms", 100, 400,
                      "a robot under manual control stops after this time without a command"});
  }
};

/// Deflection of the sticks, -1 to 1 each: positive pan is to the left, positive tilt is up.
struct Deflection {
  double pan = 0.0;   ///< of the pan stick
  double tilt = 0.0;  ///< of the tilt stick
  bool operator==(const Deflection&) const = default;
};

/// The state of manual driving, for display.
struct DriveState {
  std::optional<PanTilt> joints;  ///< as last reported by the servos; empty while they do not answer
  std::string problem;            ///< why there are no joints, or why the robot did not move; for the user
  bool driving = false;           ///< moved by the sticks
  bool armed = true;              ///< false after a stop, until the sticks have been released
  bool lent = false;              ///< moved automatically, for captures
  std::optional<LampState> lamp;  ///< as last reported; empty where the robot has none
  bool at_limit = false;          ///< driven against a limit that has been reached
};

/// Converts deflections of the sticks into motion. Deflections must be repeated: without them the robot
/// stops, and moves again only after the sticks have been released, as after halt() and after an error.
/// Targets are ahead of the joints by no more than a fraction of a second, so that the robot stops soon after
/// the sticks are released.
///
/// A separate thread communicates with the robot, so that steer(), halt() and state() do not wait for a robot
/// that does not answer. Every member may be called from any thread.
class Drive {
 public:
  /// @throws UsageError when an option is out of range
  explicit Drive(Robot& robot, const DriveOptions& options = {});
  ~Drive();  ///< stops the robot if it is being driven
  Drive(const Drive&) = delete;
  Drive& operator=(const Drive&) = delete;

  /// Sets the deflection of the sticks, until the next call or for a short time (DriveOptions::silence_ms).
  /// @param deflection clamped to -1 to 1; a magnitude below 0.02 and NaN count as released (0)
  void steer(const Deflection& deflection);

  /// Stops the robot, also when it is lent. Repeated until the robot takes the command.
  void halt();

  /// Sets the brightness of the robot's lamp, and waits until the robot has taken the command.
  /// @throws UsageError, Error as Robot::set_lamp()
  void set_lamp(int percent) { robot_.set_lamp(percent); }

  /// The state, with the joints as last reported.
  [[nodiscard]] DriveState state() const;

  /// As state(), but waits for joints that the robot is asked for after this call.
  [[nodiscard]] DriveState state_after_asking();

  /// The robot's limits when the object was constructed.
  [[nodiscard]] RobotLimits limits() const { return limits_; }

  /// For its lifetime, other code moves the robot: sticks have no effect, but halt() does. The constructor
  /// first stops a robot that is being driven; it waits up to two seconds for that.
  class Loan {
   public:
    /// @param drive must outlive the loan
    explicit Loan(Drive& drive);
    ~Loan();
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;
    /// The robot, which only the borrower may move.
    [[nodiscard]] Robot& robot() const { return drive_.robot_; }

   private:
    Drive& drive_;
  };

 private:
  /// The orders for the next step.
  struct Orders {
    Deflection deflection;
    bool halt = false;
  };

  void run(const std::stop_token& stop);
  [[nodiscard]] Orders take_orders();
  void follow(const Orders& orders);
  void advance(const Deflection& deflection);
  void stop_moving();
  void ask_joints();

  Robot& robot_;
  DriveOptions options_;
  RobotLimits limits_;
  mutable std::mutex mutex_;  // guards the members down to answers_
  std::condition_variable_any changed_;
  Deflection deflection_;
  double said_s_ = 0.0;  // time of the last steer()
  bool halt_ = false;
  bool news_ = false;
  int loans_ = 0;
  DriveState state_;
  std::uint64_t questions_ = 0;  // requests for joints that were begun
  std::uint64_t answers_ = 0;    // requests for joints that have ended
  // The following members are used by the thread alone.
  std::optional<PanTilt> target_;  // while driving
  double advanced_s_ = 0.0;
  std::string failure_;  // of the last command
  std::jthread thread_;  // last, since it uses everything above
};

}  // namespace rva
