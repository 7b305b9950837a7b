// One axis on its way.
#ifndef RVA_ROBOT_AXIS_MOTION_H
#define RVA_ROBOT_AXIS_MOTION_H

#include <stdint.h>

#include "limits.h"
#include "servo_bus.h"

namespace rva_robot {

/// Moves in pieces that one packet can say, and says again what a servo seems not to have heard.
class AxisMotion {
 public:
  /// The axis' position must be known.
  void start(int16_t target_cdeg, int16_t speed_cdeg_s);

  /// Stops the servo, and sees to it that it does.
  void stop(uint32_t now_ms);

  /// Forgets the target: the servo has let go.
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
  int16_t piece_cdeg_ = 0;  // where the piece under way ends
  uint32_t sent_ms_ = 0;
  uint16_t takes_ms_ = 0;
  uint8_t tries_ = 0;
};

}  // namespace rva_robot

#endif
