// A Herkulex DRS-0101 as its manual and captures of real ones have it, for the firmware to drive.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace rva::test {

/// What can go wrong with a servo and its wire.
struct ServoFaults {
  double packet_lost = 0.0;    ///< probability, each packet to it
  double reply_lost = 0.0;     ///< probability, each reply
  double bit_flipped = 0.0;    ///< probability, each byte either way
  std::uint8_t high_bits = 0;  ///< of a position's upper byte, undocumented
  std::uint8_t error = 0;      ///< bits of status error that come on, and come back while this is set
};

class SimulatedServo {
 public:
  /// @param angle_deg its position, which it keeps only with `torque`
  SimulatedServo(std::uint8_t id, double angle_deg, bool torque);

  /// Whole packets; @return the reply, if there is one.
  std::optional<std::vector<std::uint8_t>> take(const std::vector<std::uint8_t>& packet);

  void advance(double seconds);

  /// Where it really is, and how fast.
  [[nodiscard]] double angle_deg() const { return angle_deg_; }
  [[nodiscard]] double speed_deg_s() const { return speed_deg_s_; }
  [[nodiscard]] bool torque() const { return ram_[52] == 0x60; }
  [[nodiscard]] bool moving() const { return move_.has_value(); }

  [[nodiscard]] std::uint8_t id() const { return id_; }
  /// Sets the ID as if the factory or another tool had set it.
  void set_id(std::uint8_t id) { id_ = eep_id_ = id; }

  /// Pushes it by hand.
  void push_to(double angle_deg) { angle_deg_ = angle_deg; }

  ServoFaults faults;

 private:
  struct Move {
    double from_deg;
    double to_deg;
    double duration_s;
    double acceleration_s;
    double since_s;
  };
  [[nodiscard]] std::uint8_t status_error() const;
  [[nodiscard]] std::uint8_t status_detail() const;
  void let_go_at_fault();
  void write(std::uint8_t address, std::uint8_t value);
  [[nodiscard]] std::uint8_t read(std::uint8_t address) const;
  void jog(const std::uint8_t* data);

  void start();
  void obey(std::uint8_t command, const std::uint8_t* data, std::size_t length);

  std::uint8_t id_;
  std::uint8_t eep_id_;  // in its permanent memory, from the next start on
  double angle_deg_;
  double speed_deg_s_ = 0.0;
  double hold_deg_;
  std::optional<Move> move_;
  std::array<std::uint8_t, 256> ram_{};
};

}  // namespace rva::test
