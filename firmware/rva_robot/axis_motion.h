// The motion of one axis.
#ifndef RVA_ROBOT_AXIS_MOTION_H
#define RVA_ROBOT_AXIS_MOTION_H

#include <stdint.h>

#include "limits.h"
#include "servo_bus.h"

namespace rva_robot {

/// Splits a move into pieces that one packet can express, and repeats commands that the servo seems
/// to have missed.
class AxisMotion {
 public:
  /// Starts a move. The axis' position must be known.
  void start(int16_t target_cdeg, int16_t speed_cdeg_s);

  /// Stops the servo, and repeats the command until the servo is seen at rest.
  void stop(uint32_t now_ms);

  /// Drops the target because the servo has switched off its torque.
  void forget();

  void tick(ServoBus& bus, uint8_t axis, uint32_t now_ms);

  bool moving() const { return phase_ == Phase::due || phase_ == Phase::under_way; }

 private:
  enum class Phase : uint8_t { rest, due, under_way, stopping };

  void send_piece(ServoBus& bus, uint8_t axis, uint32_t now_ms);
  void follow(const Servo& servo, uint32_t now_ms);
  void see_it_stop(ServoBus& bus, uint8_t axis, uint32_t now_ms);

  Phase phase_ = Phase::rest;
  int16_t target_cdeg_ = 0;
  int16_t speed_cdeg_s_ = fastest_cdeg_s;
  int16_t piece_cdeg_ = 0;  // end of the current piece
  uint32_t sent_ms_ = 0;
  uint16_t takes_ms_ = 0;
  uint8_t tries_ = 0;
};

}  // namespace rva_robot

#endif
