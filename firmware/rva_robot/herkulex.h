// Packets of the Herkulex DRS-0101 servos (user manual, chapters 4 to 6).
#ifndef RVA_ROBOT_HERKULEX_H
#define RVA_ROBOT_HERKULEX_H

#include <stdint.h>

namespace rva_robot {

namespace herkulex {

enum Request : uint8_t { eep_write = 1, ram_write = 3, ram_read = 4, i_jog = 5, stat = 7, reboot = 9 };
constexpr uint8_t reply = 0x40;  ///< added to the request's code in a reply

/// The register of the ID in the permanent memory (EEP); a change counts from the next start of the servo.
constexpr uint8_t eep_id = 6;
constexpr uint8_t greatest_id = 253;

/// Registers in RAM.
enum Register : uint8_t {
  ack_policy = 1,
  acceleration_ratio = 8,  ///< percent of a move; the next register: longest acceleration in play units
  status_error = 48,       ///< the next register is the status detail
  torque = 52,
  voltage = 54,  ///< in units of 0.074 V; the next register is the temperature
  position = 58  ///< two bytes, low byte first, of which ten bits are used
};

enum Torque : uint8_t { torque_on = 0x60 };

enum Error : uint8_t {
  error_voltage = 0x01,
  error_reach = 0x02,
  error_heat = 0x04,
  error_packet = 0x08,
  error_overload = 0x10,
  error_driver = 0x20,
  error_memory = 0x40,
  lets_go = error_voltage | error_heat | error_overload | error_driver  ///< the servo switches its torque off
};

enum Detail : uint8_t { moving = 0x01, in_position = 0x02, motor_on = 0x40 };

/// Flags of a jog.
enum Set : uint8_t { set_stop = 0x01, set_green = 0x04, set_blue = 0x08, set_red = 0x10 };

constexpr uint8_t longest_play = 254;  ///< in units of 11.2 ms

}  // namespace herkulex

/// Convert between counts of the servo and hundredths of a degree: 0.325 degrees per count, 0 in the middle.
int16_t cdeg_of_count(uint16_t count);
uint16_t count_of_cdeg(int16_t cdeg);

struct Packet {
  static constexpr uint8_t most_data = 16;

  uint8_t id = 0;
  uint8_t command = 0;
  uint8_t data[most_data] = {};
  uint8_t length = 0;  ///< number of data bytes

  void add(uint8_t byte) {
    if (length < most_data) data[length++] = byte;
  }
};

constexpr uint8_t longest_packet = 7 + Packet::most_data;

/// Encodes a packet with its header and checksum.
/// @return number of bytes written
uint8_t encode(const Packet& packet, uint8_t (&bytes)[longest_packet]);

/// Finds packets in a stream of bytes, and skips damaged ones.
class PacketReader {
 public:
  /// @return whether the byte completed a valid packet
  bool take(uint8_t byte, Packet& packet);

 private:
  bool complete(Packet& packet) const;
  void drop_first();

  uint8_t bytes_[longest_packet] = {};
  uint8_t size_ = 0;
};

}  // namespace rva_robot

#endif
