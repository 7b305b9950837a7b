// The robot's controller between host and servos.
#ifndef RVA_ROBOT_ROBOT_H
#define RVA_ROBOT_ROBOT_H

#include <stdint.h>

#include "axis_motion.h"
#include "host_input.h"
#include "lamp.h"
#include "limits.h"
#include "outbox.h"
#include "port.h"
#include "servo_bus.h"
#include "text.h"

namespace rva_robot {

/// No member blocks. Call tick() at least every 5 ms.
class Robot {
 public:
  Robot(Port& host, Port& servos, LampPort& lamp);

  void take_from_host(uint8_t byte, uint32_t now_ms);
  void take_from_servos(uint8_t byte, uint32_t now_ms) { bus_.take(byte, now_ms); }
  void tick(uint32_t now_ms);

 private:
  static constexpr uint8_t position_counts_ms = 250;  // older positions are not reported

  enum class State : uint8_t { start, hold, move, lost, fault };

  void obey(Command command, uint32_t now_ms);
  Refusal carry_out(const Command& command, uint32_t now_ms);
  Refusal move(const Command& command, uint32_t now_ms);
  void stop(uint32_t now_ms);
  void clear(uint8_t axis, uint32_t now_ms);
  void answer(const Command& command, Refusal refusal);

  void keep_host_in_sight(uint32_t now_ms);
  void hold_or_recover(uint8_t axis, uint32_t now_ms);
  bool moving() const;
  bool held(uint8_t axis, uint32_t now_ms) const;
  State state(uint32_t now_ms) const;

  void report(uint32_t now_ms);
  void report_parts(uint32_t now_ms);
  void say_ready(uint32_t now_ms);
  void say_positions(uint32_t now_ms);
  void say_bare_positions(uint32_t now_ms);
  bool say_status(uint8_t axis);
  void say_lamp(uint32_t now_ms);
  bool say_found();
  bool say(const Line& line, uint8_t room_to_leave);
  bool say_frame(Line& line, uint8_t room_to_leave);

  Port& host_;
  ServoBus bus_;
  Lamp lamp_;
  HostInput input_;
  Outbox outbox_;
  AxisMotion motions_[axes];
  bool commanded_ = false;
  bool lost_ = false;
  uint32_t heard_ms_ = 0;  // time of the last valid frame
  uint32_t tended_ms_[axes] = {0, 0};
  bool tended_[axes] = {false, false};
  uint32_t positions_ms_ = 0;
  uint32_t status_ms_ = 0;
  uint8_t status_axis_ = pan;
  uint8_t status_asked_ = 0;  // number of status lines that the host has requested
  uint32_t lamp_ms_ = 0;
  bool lamp_asked_ = false;
  bool found_asked_ = false;
  uint32_t ready_ms_ = 0;
  bool ready_said_ = false;
};

}  // namespace rva_robot

#endif
