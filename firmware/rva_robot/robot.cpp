#include "robot.h"

#include "motion.h"

namespace rva_robot {
namespace {

constexpr uint16_t host_falls_silent_ms = 500;
constexpr uint8_t commands_need_ms = 100;  // maximum age of positions for a command to be accepted
constexpr uint16_t tend_every_ms = 500;
constexpr uint8_t hold_every_ms = 100;

}  // namespace

Robot::Robot(Port& host, Port& servos, LampPort& lamp) : host_(host), bus_(servos), lamp_(lamp) {}

void Robot::take_from_host(uint8_t byte, uint32_t now_ms) {
  input_.take(byte, now_ms);
  Command command;
  while (input_.next(command)) obey(command, now_ms);
}

void Robot::tick(uint32_t now_ms) {
  input_.tick(now_ms);
  Command command;
  while (input_.next(command)) obey(command, now_ms);
  keep_host_in_sight(now_ms);
  for (uint8_t axis = 0; axis < axes; ++axis) {
    hold_or_recover(axis, now_ms);
    motions_[axis].tick(bus_, axis, now_ms);
  }
  bus_.tick(now_ms);
  lamp_.tick(now_ms);
  report(now_ms);
  outbox_.drain(host_);
}

void Robot::obey(Command command, uint32_t now_ms) {
  if (command.refusal != Refusal::crc) {
    commanded_ = true;
    if (command.framed) heard_ms_ = now_ms;
  }
  const Refusal refusal = command.refusal == Refusal::none ? carry_out(command, now_ms) : command.refusal;
  if (command.framed) answer(command, refusal);
}

Refusal Robot::carry_out(const Command& command, uint32_t now_ms) {
  switch (command.verb) {
    case Verb::move:
      return move(command, now_ms);
    case Verb::stop:
      stop(now_ms);
      break;
    case Verb::clear:
      for (uint8_t axis = 0; axis < axes; ++axis) clear(axis, now_ms);
      break;
    case Verb::info:
      ready_said_ = false;
      status_asked_ = axes;
      lamp_asked_ = true;
      break;
    case Verb::find:
      stop(now_ms);
      bus_.find();
      found_asked_ = true;
      break;
    case Verb::middle:
      // A stop is repeated until the servo rests, so the servo that is to turn gets none.
      for (uint8_t axis = 0; axis < axes; ++axis)
        servo_id[axis] == command.servo_from ? motions_[axis].forget() : motions_[axis].stop(now_ms);
      return bus_.turn_to_middle(command.servo_from) ? Refusal::none : Refusal::blind;
    case Verb::name:
      stop(now_ms);
      return bus_.name(command.servo_from, command.servo_to, now_ms) ? Refusal::none : Refusal::blind;
    case Verb::lamp:
      lamp_asked_ = true;
      return lamp_.set(command.lamp_percent) ? Refusal::none : Refusal::heat;
    case Verb::ping:
      break;
  }
  return Refusal::none;
}

Refusal Robot::move(const Command& command, uint32_t now_ms) {
  for (uint8_t axis = 0; axis < axes; ++axis) {
    const Servo& servo = bus_.servo(axis);
    if (!servo.known(now_ms, commands_need_ms)) return Refusal::blind;
    if ((servo.error & herkulex::lets_go) != 0) return Refusal::fault;
    if (!held(axis, now_ms)) return Refusal::blind;
  }
  for (uint8_t axis = 0; axis < axes; ++axis) {
    if (command.moves[axis]) motions_[axis].start(command.target_cdeg[axis], command.speed_cdeg_s);
  }
  lost_ = false;
  return Refusal::none;
}

void Robot::stop(uint32_t now_ms) {
  for (uint8_t axis = 0; axis < axes; ++axis) motions_[axis].stop(now_ms);
}

void Robot::clear(uint8_t axis, uint32_t now_ms) {
  const uint8_t none[2] = {0, 0};
  const uint8_t on = herkulex::torque_on;
  bus_.write(axis, herkulex::status_error, none, 2);
  bus_.write(axis, herkulex::torque, &on, 1);
  tended_ms_[axis] = now_ms;
}

void Robot::keep_host_in_sight(uint32_t now_ms) {
  if (!input_.framed() || now_ms - heard_ms_ < host_falls_silent_ms) return;
  if (lamp_.percent() > 0) (void)lamp_.set(0);
  if (!moving()) return;
  stop(now_ms);
  lost_ = true;
}

// Switches torque on only if the position is known, so that the axis does not jump. A servo with a fault has
// switched its torque off, so its target is dropped.
void Robot::hold_or_recover(uint8_t axis, uint32_t now_ms) {
  const Servo& servo = bus_.servo(axis);
  if (!servo.known(now_ms, commands_need_ms)) return;
  if ((servo.error & herkulex::lets_go) != 0) {
    motions_[axis].forget();
    if (now_ms - tended_ms_[axis] >= tend_every_ms) clear(axis, now_ms);
    return;
  }
  const bool due = !tended_[axis] || now_ms - tended_ms_[axis] >= hold_every_ms;
  if (!due || (held(axis, now_ms) && servo.error == 0)) return;
  // A move that was started before a reset of this board is no longer monitored, so it is stopped.
  if (!tended_[axis]) motions_[axis].stop(now_ms);
  const uint8_t acceleration[2] = {acceleration_percent, longest_acceleration_play};
  if (bus_.write(axis, herkulex::acceleration_ratio, acceleration, 2)) tended_[axis] = true;
  clear(axis, now_ms);
}

bool Robot::moving() const { return motions_[pan].moving() || motions_[tilt].moving(); }

bool Robot::held(uint8_t axis, uint32_t now_ms) const {
  const Servo& servo = bus_.servo(axis);
  return tended_[axis] && servo.known(now_ms, position_counts_ms) && (servo.detail & herkulex::motor_on) != 0;
}

Robot::State Robot::state(uint32_t now_ms) const {
  for (uint8_t axis = 0; axis < axes; ++axis) {
    if ((bus_.servo(axis).error & herkulex::lets_go) != 0) return State::fault;
  }
  if (!held(pan, now_ms) || !held(tilt, now_ms)) return State::start;
  if (moving()) return State::move;
  return lost_ ? State::lost : State::hold;
}

}  // namespace rva_robot
