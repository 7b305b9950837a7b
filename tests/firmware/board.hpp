// The robot's board with both servos on its second line, in simulated time.
#pragma once

#include <array>
#include <cstdint>
#include <deque>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include "tests/firmware/simulated_servo.hpp"

namespace rva::test {

/// Firmware somewhere, reached over two serial lines of 115200 baud.
class Firmware {
 public:
  Firmware() = default;
  virtual ~Firmware() = default;
  Firmware(const Firmware&) = delete;
  Firmware& operator=(const Firmware&) = delete;

  /// Bytes as they arrive: no faster than a line carries them.
  virtual void from_host(std::uint8_t byte) = 0;
  virtual void from_servos(std::uint8_t byte) = 0;
  /// The voltage at the lamp's thermistor as a share of its supply, 0 to 1.
  virtual void set_thermistor(double /*share*/) {}
  /// The share of time for which the LEDs are on, 0 to 1.
  [[nodiscard]] virtual double lamp() { return 0.0; }
  /// Runs for a tenth of a millisecond, a little more than a byte takes.
  virtual void step() = 0;

  /// What it has written since they were last emptied.
  std::vector<std::uint8_t> to_host;
  std::vector<std::uint8_t> to_servos;
};

/// The logic itself, compiled for this machine.
std::unique_ptr<Firmware> native_firmware(std::uint32_t start_ms = 0);
/// The built program on a simulated ATmega2560; null where it was not built.
std::unique_ptr<Firmware> simulated_board();

struct BuiltSize {
  std::uint32_t flash_bytes;
  std::uint32_t memory_bytes;  ///< without the stack
};
/// Of the built program; empty where it was not built.
std::optional<BuiltSize> built_size();

/// Both ends of the lines, and what happened.
class Board {
 public:
  static constexpr double step_s = 0.0001;

  struct Start {
    double pan_deg = 0.0;
    double tilt_deg = 0.0;
    bool torque = false;
  };
  Board(std::unique_ptr<Firmware> firmware, Start start, std::uint64_t seed = 1);

  /// Queues bytes for the host's line.
  void send(const std::string& bytes);
  /// Puts number and checksum around it and queues it; @return its number.
  int send_frame(const std::string& body);
  void run_ms(double ms);
  /// Runs until the firmware has given positions; @return whether that was within two seconds.
  bool run_until_ready();

  /// The board starts anew; its servos stay as they are.
  void reset(std::unique_ptr<Firmware> firmware);

  /// Bytes that the host has got since they were last taken.
  std::string take_bytes() { return std::exchange(bytes_, ""); }
  /// Lines that the host has got, without their ends, since they were last taken.
  std::vector<std::string> take_lines();
  /// The answer to one frame, running for up to 100 ms: "ACK 7"; empty where none came.
  std::string answer(int number);

  [[nodiscard]] double now_ms() const { return 1000.0 * step_s * static_cast<double>(steps_); }
  [[nodiscard]] SimulatedServo& pan() { return servos_[0]; }
  [[nodiscard]] SimulatedServo& tilt() { return servos_[1]; }
  /// The share of time for which the LEDs are on, 0 to 1.
  [[nodiscard]] double lamp() { return firmware_->lamp(); }
  /// Degrees Celsius at the lamp's thermistor; empty: its cable is cut.
  std::optional<double> lamp_celsius = 25.0;

  /// Over the whole run.
  struct Extremes {
    double fastest_deg_s = 0.0;  ///< with torque
    double pan_low_deg = 0.0;
    double pan_high_deg = 0.0;
    double tilt_low_deg = 0.0;
    double tilt_high_deg = 0.0;
    double longest_silence_ms = 0.0;  ///< between lines to the host
  };
  [[nodiscard]] const Extremes& extremes() const { return extremes_; }
  void forget_extremes();

  /// Probability that a byte from the host has a bit flipped.
  double host_bit_flipped = 0.0;
  /// When the first packet that commands motion reached the servos since this was reset to below 0.
  double first_jog_ms = -1.0;

 private:
  void step();
  void carry_host();
  void carry_servos();
  void take_packet();
  void hand_packet_to(SimulatedServo& servo);
  void watch();
  std::uint8_t perhaps_flipped(std::uint8_t byte, double probability);
  bool chance(double probability);

  std::unique_ptr<Firmware> firmware_;
  std::array<SimulatedServo, 2> servos_;
  std::mt19937_64 random_;
  std::int64_t steps_ = 0;
  std::deque<std::uint8_t> host_queue_;
  struct Due {
    std::int64_t step;
    std::uint8_t byte;
  };
  std::deque<Due> replies_;
  std::vector<std::uint8_t> packet_;
  std::string bytes_;
  std::string line_;
  std::vector<std::string> lines_;
  double last_line_ms_ = 0.0;
  int number_ = 0;
  Extremes extremes_;
};

}  // namespace rva::test
