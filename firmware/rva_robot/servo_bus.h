// Communication with both servos, and their last known state.
#ifndef RVA_ROBOT_SERVO_BUS_H
#define RVA_ROBOT_SERVO_BUS_H

#include <stdint.h>

#include "herkulex.h"
#include "limits.h"
#include "port.h"

namespace rva_robot {

constexpr uint8_t servo_id[axes] = {1, 2};

/// The measured state of one servo; no value is estimated.
struct Servo {
  bool answered = false;  ///< whether the servo has ever reported a position
  int16_t cdeg = 0;
  uint32_t measured_ms = 0;
  uint8_t error = 0;  ///< error bits that are set in both of the last two answers
  uint8_t detail = 0;
  bool supply_known = false;
  uint8_t voltage = 0;  ///< in units of 0.074 V
  uint8_t heat = 0;     ///< temperature, the raw value of register 55

  bool known(uint32_t now_ms, uint16_t no_older_ms) const {
    return answered && now_ms - measured_ms <= no_older_ms;
  }

  /// Take a reported position or status. The servos' checksum does not cover the lowest bit of any byte,
  /// which is 83 degrees in the upper byte of a position, and a fault in a status. Therefore, implausible
  /// positions and all faults must be reported twice before they are accepted.
  void take_position(int16_t cdeg, uint32_t now_ms);
  void take_status(uint8_t error, uint8_t detail);

 private:
  bool doubted_ = false;
  int16_t doubted_cdeg_ = 0;
  uint32_t doubted_ms_ = 0;
  uint8_t last_error_ = 0;
};

/// Polls the servos alternately without blocking; a lost answer is replaced by that to a later request.
class ServoBus {
 public:
  explicit ServoBus(Port& port) : port_(port) {}

  void take(uint8_t byte, uint32_t now_ms);

  /// Sends the next request if it is due.
  void tick(uint32_t now_ms);

  const Servo& servo(uint8_t axis) const { return servos_[axis]; }

  /// Asks every ID in turn for its status, which takes two seconds at most. Positions are not asked
  /// meanwhile.
  void find();
  bool finding() const { return finding_; }
  bool found(uint8_t id) const { return (found_[id / 8] & (1U << (id % 8))) != 0; }

  /// Gives a servo another ID for good, and starts it anew a moment later, so that the ID counts.
  /// @return false if the port had no room for it
  bool name(uint8_t from, uint8_t to, uint32_t now_ms);

  /// Holds a servo and turns it to its middle, in three seconds, whatever carries it.
  /// @return false if the port had no room for it
  bool turn_to_middle(uint8_t id);

  /// Send a command; servos do not answer commands.
  /// @return false if the port had no room for it
  bool write(uint8_t axis, uint8_t from_register, const uint8_t* values, uint8_t count);
  bool move(uint8_t axis, int16_t to_cdeg, uint8_t play);
  bool stop(uint8_t axis);

 private:
  bool send(const Packet& packet);
  bool write_to(uint8_t id, uint8_t from_register, const uint8_t* values, uint8_t count);
  bool jog(uint8_t id, uint16_t count, uint8_t set, uint8_t play);
  bool send_bare(uint8_t id, uint8_t command);
  void ask(uint32_t now_ms);
  void ask_next_id(uint32_t now_ms);

  Port& port_;
  PacketReader reader_;
  Servo servos_[axes];
  uint8_t asked_axis_ = tilt;
  uint8_t asked_register_ = herkulex::position;
  bool waiting_ = false;
  uint32_t asked_ms_ = 0;
  uint32_t supply_asked_ms_[axes] = {0, 0};
  bool finding_ = false;
  uint8_t next_id_ = 0;
  uint8_t found_[32] = {};
  bool naming_ = false;
  uint8_t named_ = 0;  // the ID until the servo starts anew
  uint32_t named_ms_ = 0;
};

}  // namespace rva_robot

#endif
