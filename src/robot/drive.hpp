// Driving by hand: hold to run, let go to stop.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "core/clock.hpp"
#include "core/options.hpp"
#include "robot/robot.hpp"

namespace rva {

struct DriveOptions {
  double speed_deg_s = 30.0;
  int silence_ms = 250;

  static void describe(auto&& self, auto&& visit) {
    visit(self.speed_deg_s,
          OptionField{"speed", "deg_s", 0.1, 90, "how fast a stick held at its end turns a joint"});
    visit(self.silence_ms, OptionField{"silence", "ms", 100, 400,
                                       "a robot driven by hand stops when nobody has said how for so long"});
  }
};

/// How far the sticks are held, -1 to 1 each: pan to the left, tilt up.
struct Deflection {
  double pan = 0.0;
  double tilt = 0.0;
  bool operator==(const Deflection&) const = default;
};

struct DriveState {
  std::optional<PanTilt> joints;  ///< as the servos last said; empty while they do not
  std::string problem;            ///< why not, or why it did not move, for a person
  bool driving = false;
  bool armed = true;      ///< false after a stop until the sticks were let go
  bool lent = false;      ///< moves by itself, for a capture
  bool at_limit = false;  ///< held towards an end that is reached
};

/// Turns sticks into motion. Deflections must come again and again: silence stops the robot, and then only
/// sticks that have been let go move it again, as after halt() and after an error. Targets are ahead of the
/// joints by no more than a fraction of a second, so that nothing is left to run when the sticks are let go.
///
/// The robot is spoken to by a thread of its own, so that no member waits for a robot that does not answer.
/// Every member may be called from any thread.
class Drive {
 public:
  /// @throws UsageError when an option is out of range
  explicit Drive(Robot& robot, const DriveOptions& options = {});
  ~Drive();  ///< stops the robot if it drives it
  Drive(const Drive&) = delete;
  Drive& operator=(const Drive&) = delete;

  /// @param deflection beyond 1 counts as 1, less than 0.02 either way and not a number as 0: let go
  void steer(const Deflection& deflection);

  /// Stops the robot, whoever moves it.
  void halt();

  [[nodiscard]] DriveState state() const;

  /// As state(), but what the robot answers to a question that is asked from now on: waits for that.
  [[nodiscard]] DriveState state_after_asking();

  [[nodiscard]] RobotLimits limits() const { return limits_; }

  /// While it lives, the robot is moved by somebody else, and sticks have no say; halt() does. It begins when
  /// the robot has been told to stop, if it was driven.
  class Loan {
   public:
    explicit Loan(Drive& drive);
    ~Loan();
    Loan(const Loan&) = delete;
    Loan& operator=(const Loan&) = delete;
    [[nodiscard]] Robot& robot() const { return drive_.robot_; }

   private:
    Drive& drive_;
  };

 private:
  /// What the next step is to do.
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
  mutable std::mutex mutex_;  // guards up to the thread's own
  std::condition_variable_any changed_;
  Deflection deflection_;
  double said_s_ = 0.0;  // when the deflection was
  bool halt_ = false;
  bool news_ = false;
  int loans_ = 0;
  DriveState state_;
  std::uint64_t questions_ = 0;  // begun, and
  std::uint64_t answers_ = 0;    // ended: how often the robot was asked for its joints
  // Of the thread alone.
  std::optional<PanTilt> target_;  // while driving
  double advanced_s_ = 0.0;
  std::string failure_;  // of the last command
  std::jthread thread_;  // last: it uses all above
};

}  // namespace rva
