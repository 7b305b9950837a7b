// The RVA's robot: an Arduino MEGA 2560 between the host (USB), two Herkulex DRS-0101 servos (Serial1) and
// the lamp: the gate of a MOSFET at pin 6, the thermistor at pin A0. See docs/protocol.md. All code that can
// be tested without a board is in the other files.
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

class LampPins : public rva_robot::LampPort {
 public:
  void drive(uint8_t level) { analogWrite(leds, level); }
  uint16_t thermistor() { return static_cast<uint16_t>(analogRead(A0)); }

  // Pulses at 31 kHz: images of the same exposure get the same light, which those at 490 Hz would not.
  void begin() { TCCR4B = static_cast<uint8_t>((TCCR4B & 0xF8) | 0x01); }

 private:
  static constexpr uint8_t leds = 6;
};

constexpr uint32_t baud = 115200;
// Limits the bytes read per loop, so that a burst from the host does not delay the servos.
constexpr uint8_t bytes_at_once = 16;

SerialPort host(Serial);
SerialPort servos(Serial1);
LampPins lamp;
rva_robot::Robot robot(host, servos, lamp);

}  // namespace

void setup() {
  wdt_enable(WDTO_250MS);
  Serial.begin(baud);
  Serial1.begin(baud);
  lamp.begin();
}

void loop() {
  wdt_reset();
  for (uint8_t i = 0; i < bytes_at_once && Serial.available() > 0; ++i)
    robot.take_from_host(static_cast<uint8_t>(Serial.read()), millis());
  for (uint8_t i = 0; i < bytes_at_once && Serial1.available() > 0; ++i)
    robot.take_from_servos(static_cast<uint8_t>(Serial1.read()), millis());
  robot.tick(millis());
}
