// The RVA's robot: an Arduino MEGA 2560 between the host (USB) and two Herkulex DRS-0101 servos (Serial1).
// See docs/protocol.md. All code that can be tested without a board is in the other files.
#include <Arduino.h>
#include <avr/wdt.h>

#include "robot.h"

namespace {

class SerialPort : public rva_robot::Port {
 public:
  explicit SerialPort(HardwareSerial& serial) : serial_(serial) {}
  uint8_t room() const { return static_cast<uint8_t>(serial_.availableForWrite()); }
  void write(const uint8_t* bytes, uint8_t count) { serial_.write(bytes, count); }

 private:
  HardwareSerial& serial_;
};

constexpr uint32_t baud = 115200;
// Limits the bytes read per loop, so that a burst from the host does not delay the servos.
constexpr uint8_t bytes_at_once = 16;

SerialPort host(Serial);
SerialPort servos(Serial1);
rva_robot::Robot robot(host, servos);

}  // namespace

void setup() {
  wdt_enable(WDTO_250MS);
  Serial.begin(baud);
  Serial1.begin(baud);
}

void loop() {
  wdt_reset();
  for (uint8_t i = 0; i < bytes_at_once && Serial.available() > 0; ++i)
    robot.take_from_host(static_cast<uint8_t>(Serial.read()), millis());
  for (uint8_t i = 0; i < bytes_at_once && Serial1.available() > 0; ++i)
    robot.take_from_servos(static_cast<uint8_t>(Serial1.read()), millis());
  robot.tick(millis());
}
