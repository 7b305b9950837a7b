// The lines that the robot sends to its host.
#include "robot.h"
#include "version.h"

namespace rva_robot {
namespace {

constexpr uint8_t positions_every_ms = 25;
constexpr uint16_t status_every_ms = 250;  // alternating between the axes
constexpr uint16_t lamp_every_ms = 500;
constexpr uint16_t ready_every_ms = 1000;
constexpr uint16_t millivolts_a_count = 74;
constexpr uint8_t most_found = 8;    // servos that are reported
constexpr uint8_t for_answers = 64;  // bytes of the outbox reserved for answers

const char* const axis_names[axes] = {"PAN", "TILT"};

}  // namespace

void Robot::report(uint32_t now_ms) {
  if (!ready_said_ || (!commanded_ && now_ms - ready_ms_ >= ready_every_ms)) say_ready(now_ms);
  if (now_ms - positions_ms_ >= positions_every_ms) {
    positions_ms_ = now_ms;
    input_.framed() ? say_positions(now_ms) : say_bare_positions(now_ms);
  }
  if (input_.framed()) report_parts(now_ms);
}

void Robot::report_parts(uint32_t now_ms) {
  if (found_asked_ && !bus_.finding() && say_found()) found_asked_ = false;
  if (lamp_asked_ || now_ms - lamp_ms_ >= lamp_every_ms) say_lamp(now_ms);
  if (status_asked_ == 0 && now_ms - status_ms_ < status_every_ms) return;
  if (!say_status(status_axis_)) return;
  status_ms_ = now_ms;
  status_axis_ = static_cast<uint8_t>(1 - status_axis_);
  if (status_asked_ > 0) --status_asked_;
}

void Robot::answer(const Command& command, Refusal refusal) {
  static const char* const reasons[] = {"", "CRC", "FORM", "LIMIT", "BLIND", "FAULT", "HEAT"};
  Line line;
  if (refusal == Refusal::none)
    line.text("ACK ").number(command.number);
  else
    line.text("NAK ").number(command.number).character(' ').text(reasons[static_cast<uint8_t>(refusal)]);
  say_frame(line, 0);
}

void Robot::say_ready(uint32_t now_ms) {
  Line line;
  line.text("READY ").number(protocol_version).character(' ').text(firmware_version);
  for (const AxisLimits& axis : limits) {
    line.character(' ').integer(axis.min_cdeg / 100);
    line.character(' ').integer(axis.max_cdeg / 100);
  }
  line.character(' ').integer(fastest_cdeg_s / 100);
  if (!say_frame(line, for_answers)) return;
  ready_said_ = true;
  ready_ms_ = now_ms;
}

void Robot::say_positions(uint32_t now_ms) {
  static const char* const states[] = {"START", "HOLD", "MOVE", "LOST", "FAULT"};
  Line line;
  line.text("POS ").number(now_ms);
  for (uint8_t axis = 0; axis < axes; ++axis) {
    const Servo& servo = bus_.servo(axis);
    line.character(' ');
    if (servo.known(now_ms, position_counts_ms))
      line.decimal(servo.cdeg, 2).character(' ').number(now_ms - servo.measured_ms);
    else
      line.text("- -");
  }
  line.character(' ').text(states[static_cast<uint8_t>(state(now_ms))]);
  say_frame(line, for_answers);
}

void Robot::say_bare_positions(uint32_t now_ms) {
  Line line;
  for (uint8_t axis = 0; axis < axes; ++axis) {
    const Servo& servo = bus_.servo(axis);
    if (!servo.known(now_ms, position_counts_ms)) return;
    if (axis == tilt) line.character('x');
    line.decimal(servo.cdeg, 2);
  }
  line.text("\r\n");
  say(line, for_answers);
}

bool Robot::say_status(uint8_t axis) {
  const Servo& servo = bus_.servo(axis);
  Line line;
  line.text("STAT ").text(axis_names[axis]).character(' ');
  if (servo.answered)
    line.hex(servo.error, 2).character(' ').hex(servo.detail, 2);
  else
    line.text("- -");
  line.character(' ');
  if (servo.supply_known)
    line.decimal(static_cast<int32_t>(servo.voltage) * millivolts_a_count / 100, 1)
        .character(' ')
        .number(servo.heat);
  else
    line.text("- -");
  return say_frame(line, for_answers);
}

void Robot::say_lamp(uint32_t now_ms) {
  Line line;
  line.text("LAMP ").number(lamp_.percent()).character(' ');
  if (lamp_.heat_dc() == no_heat)
    line.text("- NONE");
  else
    line.decimal(lamp_.heat_dc(), 1).text(lamp_.too_hot() ? " HOT" : " COOL");
  if (!say_frame(line, for_answers)) return;
  lamp_asked_ = false;
  lamp_ms_ = now_ms;
}

bool Robot::say_found() {
  Line line;
  line.text("FOUND");
  uint8_t listed = 0;
  for (uint16_t id = 0; id <= herkulex::greatest_id && listed < most_found; ++id) {
    if (!bus_.found(static_cast<uint8_t>(id))) continue;
    line.character(' ').number(id);
    ++listed;
  }
  return say_frame(line, for_answers);
}

// Lines for which there is no room are dropped: the next positions are newer, and hosts
// repeat their requests.
bool Robot::say(const Line& line, uint8_t room_to_leave) {
  if (!line.sound() || outbox_.room() < line.size() + room_to_leave) return false;
  return outbox_.put(line.data(), line.size());
}

bool Robot::say_frame(Line& line, uint8_t room_to_leave) {
  line.close_frame();
  return say(line, room_to_leave);
}

}  // namespace rva_robot
