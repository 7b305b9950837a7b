#include "servo_bus.h"

namespace rva_robot {
namespace {

constexpr uint8_t answer_within_ms = 6;
constexpr uint8_t ask_every_ms = 6;        // which yields the position of each servo every 12 ms
constexpr uint8_t restart_after_ms = 100;  // writing the permanent memory takes a few milliseconds
constexpr uint16_t ask_supply_every_ms = 500;
constexpr uint16_t position_bits = 0x3FF;  // the higher bits are undocumented and not always 0

// Whether a position is plausible after an earlier one, even for a servo that is pushed by hand.
bool follows(int16_t cdeg, int16_t before_cdeg, uint32_t since_ms) {
  constexpr uint8_t cdeg_a_ms = 15;
  constexpr int32_t rounding_cdeg = 200;
  const int32_t between = cdeg > before_cdeg ? static_cast<int32_t>(cdeg) - before_cdeg
                                             : static_cast<int32_t>(before_cdeg) - cdeg;
  return since_ms < 1000 && between <= rounding_cdeg + static_cast<int32_t>(since_ms) * cdeg_a_ms;
}

}  // namespace

void Servo::take_position(int16_t new_cdeg, uint32_t now_ms) {
  const bool believed = (answered && follows(new_cdeg, cdeg, now_ms - measured_ms)) ||
                        (doubted_ && follows(new_cdeg, doubted_cdeg_, now_ms - doubted_ms_));
  doubted_ = !believed;
  doubted_cdeg_ = new_cdeg;
  doubted_ms_ = now_ms;
  if (!believed) return;
  answered = true;
  cdeg = new_cdeg;
  measured_ms = now_ms;
}

void Servo::take_status(uint8_t new_error, uint8_t new_detail) {
  error = new_error & last_error_;
  last_error_ = new_error;
  detail = new_detail;
}

void ServoBus::take(uint8_t byte, uint32_t now_ms) {
  Packet packet;
  if (!reader_.take(byte, packet) || !waiting_) return;
  if (finding_) {
    if (packet.command != herkulex::stat + herkulex::reply) return;
    found_[packet.id / 8] = static_cast<uint8_t>(found_[packet.id / 8] | (1U << (packet.id % 8)));
    waiting_ = false;
    return;
  }
  // An answer contains the register, the number of values, the values, and both bytes of status.
  if (packet.command != herkulex::ram_read + herkulex::reply || packet.id != servo_id[asked_axis_]) return;
  if (packet.length != 6 || packet.data[0] != asked_register_ || packet.data[1] != 2) return;
  waiting_ = false;
  Servo& servo = servos_[asked_axis_];
  servo.take_status(packet.data[4], packet.data[5]);
  if (asked_register_ == herkulex::position) {
    const uint16_t count = static_cast<uint16_t>(packet.data[2] | (packet.data[3] << 8));
    servo.take_position(cdeg_of_count(count & position_bits), now_ms);
  } else {
    servo.voltage = packet.data[2];
    servo.heat = packet.data[3];
    servo.supply_known = true;
  }
}

void ServoBus::tick(uint32_t now_ms) {
  const uint32_t since_ms = now_ms - asked_ms_;
  if (waiting_ && since_ms < answer_within_ms) return;
  if (naming_ && now_ms - named_ms_ >= restart_after_ms) {
    if (send_bare(named_, herkulex::reboot)) naming_ = false;
  } else if (finding_) {
    ask_next_id(now_ms);
  } else if (since_ms >= ask_every_ms) {
    ask(now_ms);
  }
}

void ServoBus::find() {
  finding_ = true;
  waiting_ = false;
  next_id_ = 0;
  for (uint8_t& eight : found_) eight = 0;
}

void ServoBus::ask_next_id(uint32_t now_ms) {
  if (next_id_ > herkulex::greatest_id) {
    finding_ = false;
    waiting_ = false;
    return;
  }
  if (!send_bare(next_id_, herkulex::stat)) return;
  ++next_id_;
  asked_ms_ = now_ms;
  waiting_ = true;
}

bool ServoBus::name(uint8_t from, uint8_t to, uint32_t now_ms) {
  Packet packet;
  packet.id = from;
  packet.command = herkulex::eep_write;
  packet.add(herkulex::eep_id);
  packet.add(1);
  packet.add(to);
  if (!send(packet)) return false;
  naming_ = true;
  named_ = from;
  named_ms_ = now_ms;
  return true;
}

bool ServoBus::write(uint8_t axis, uint8_t from_register, const uint8_t* values, uint8_t count) {
  return write_to(servo_id[axis], from_register, values, count);
}

bool ServoBus::turn_to_middle(uint8_t id) {
  const uint8_t on = herkulex::torque_on;
  return write_to(id, herkulex::torque, &on, 1) &&
         jog(id, count_of_cdeg(0), herkulex::set_green, herkulex::longest_play);
}

bool ServoBus::write_to(uint8_t id, uint8_t from_register, const uint8_t* values, uint8_t count) {
  Packet packet;
  packet.id = id;
  packet.command = herkulex::ram_write;
  packet.add(from_register);
  packet.add(count);
  for (uint8_t i = 0; i < count; ++i) packet.add(values[i]);
  return send(packet);
}

bool ServoBus::move(uint8_t axis, int16_t to_cdeg, uint8_t play) {
  return jog(servo_id[axis], count_of_cdeg(to_cdeg), herkulex::set_green, play);
}

bool ServoBus::stop(uint8_t axis) {
  const uint16_t here = count_of_cdeg(servos_[axis].cdeg);
  return jog(servo_id[axis], here, herkulex::set_stop | herkulex::set_blue, 0);
}

bool ServoBus::jog(uint8_t id, uint16_t count, uint8_t set, uint8_t play) {
  Packet packet;
  packet.id = id;
  packet.command = herkulex::i_jog;
  packet.add(static_cast<uint8_t>(count & 0xFF));
  packet.add(static_cast<uint8_t>(count >> 8));
  packet.add(set);
  packet.add(id);
  packet.add(play);
  return send(packet);
}

bool ServoBus::send_bare(uint8_t id, uint8_t command) {
  Packet packet;
  packet.id = id;
  packet.command = command;
  return send(packet);
}

bool ServoBus::send(const Packet& packet) {
  uint8_t bytes[longest_packet];
  const uint8_t size = encode(packet, bytes);
  if (port_.room() < size) return false;
  port_.write(bytes, size);
  return true;
}

// Asks the servos alternately for their position, and at intervals for voltage and temperature instead.
void ServoBus::ask(uint32_t now_ms) {
  const uint8_t axis = static_cast<uint8_t>(1 - asked_axis_);
  const bool supply = now_ms - supply_asked_ms_[axis] >= ask_supply_every_ms && servos_[axis].answered;
  Packet packet;
  packet.id = servo_id[axis];
  packet.command = herkulex::ram_read;
  packet.add(supply ? herkulex::voltage : herkulex::position);
  packet.add(2);
  if (!send(packet)) return;
  if (supply) supply_asked_ms_[axis] = now_ms;
  asked_axis_ = axis;
  asked_register_ = packet.data[0];
  asked_ms_ = now_ms;
  waiting_ = true;
}

}  // namespace rva_robot
