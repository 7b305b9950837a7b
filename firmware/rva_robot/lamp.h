// The lamp around the camera: LEDs, and a thermistor in their frame.
#ifndef RVA_ROBOT_LAMP_H
#define RVA_ROBOT_LAMP_H

#include <stdint.h>

namespace rva_robot {

/// The board's side of the lamp.
class LampPort {
 public:
  /// Sets the share of time during which the LEDs are on, 0 to 255.
  virtual void drive(uint8_t level) = 0;
  /// The voltage at the thermistor, as a share of its supply, 0 to 1023.
  virtual uint16_t thermistor() = 0;

 protected:
  ~LampPort() = default;
};

/// Temperature of a thermistor of 10 kOhm at 25 degrees Celsius (B = 3950 K) that a resistor of 10 kOhm
/// connects to its supply.
/// @param counts 0 to 1023
/// @return tenths of a degree Celsius, from -200 to 1000; no_heat where the thermistor is not connected, is
///         shorted, or is colder or hotter than this
int16_t heat_of(uint16_t counts);
constexpr int16_t no_heat = INT16_MIN;

/// Switches the LEDs off above this temperature. Their frame is printed of PETG, which softens at 80 degrees.
constexpr int16_t hottest_dc = 600;
/// Once too hot, the lamp can be switched on again below this temperature.
constexpr int16_t cool_dc = 500;

/// The lamp is off at first, when it is too hot, and while its temperature is not known.
class Lamp {
 public:
  explicit Lamp(LampPort& port) : port_(port) {}

  /// @param percent 0 to 100
  /// @return false if the lamp stays off because of its temperature
  bool set(uint8_t percent);
  /// Measures the temperature if that is due, and switches the LEDs off where it demands this.
  void tick(uint32_t now_ms);

  uint8_t percent() const { return percent_; }
  /// Tenths of a degree Celsius; no_heat if not known.
  int16_t heat_dc() const { return heat_dc_; }
  bool too_hot() const { return too_hot_; }

 private:
  static constexpr uint8_t readings = 8;  // for one temperature

  void measured();

  LampPort& port_;
  uint8_t percent_ = 0;
  int16_t heat_dc_ = no_heat;
  bool too_hot_ = false;
  uint16_t sum_ = 0;
  uint8_t count_ = 0;
  uint32_t read_ms_ = 0;
};

}  // namespace rva_robot

#endif
