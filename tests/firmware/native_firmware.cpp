#include "firmware/rva_robot/robot.h"
#include "tests/firmware/board.hpp"

namespace rva::test {
namespace {

/// What a UART's buffer is: 63 bytes, emptied at the line's speed.
class Line : public rva_robot::Port {
 public:
  [[nodiscard]] std::uint8_t room() const override { return static_cast<std::uint8_t>(63 - buffer_.size()); }
  void write(const std::uint8_t* bytes, std::uint8_t count) override {
    buffer_.insert(buffer_.end(), bytes, bytes + count);
  }
  void carry_one(std::vector<std::uint8_t>& to) {
    if (buffer_.empty()) return;
    to.push_back(buffer_.front());
    buffer_.pop_front();
  }

 private:
  std::deque<std::uint8_t> buffer_;
};

class LampPins : public rva_robot::LampPort {
 public:
  void drive(std::uint8_t level) override { level_ = level; }
  std::uint16_t thermistor() override { return counts_; }
  void set_thermistor(double share) { counts_ = static_cast<std::uint16_t>(1023.0 * share); }
  [[nodiscard]] double share() const { return level_ / 255.0; }

 private:
  std::uint8_t level_ = 0;
  std::uint16_t counts_ = 0;
};

class NativeFirmware : public Firmware {
 public:
  explicit NativeFirmware(std::uint32_t start_ms) : start_ms_(start_ms) {}

  void from_host(std::uint8_t byte) override { robot_.take_from_host(byte, now_ms()); }
  void from_servos(std::uint8_t byte) override { robot_.take_from_servos(byte, now_ms()); }
  void set_thermistor(double share) override { lamp_.set_thermistor(share); }
  [[nodiscard]] double lamp() override { return lamp_.share(); }
  void step() override {
    robot_.tick(now_ms());
    host_.carry_one(to_host);
    servos_.carry_one(to_servos);
    ++steps_;
  }

 private:
  [[nodiscard]] std::uint32_t now_ms() const { return start_ms_ + steps_ / 10; }

  Line host_;
  Line servos_;
  LampPins lamp_;
  rva_robot::Robot robot_{host_, servos_, lamp_};
  std::uint32_t start_ms_;
  std::uint32_t steps_ = 0;
};

}  // namespace

std::unique_ptr<Firmware> native_firmware(std::uint32_t start_ms) {
  return std::make_unique<NativeFirmware>(start_ms);
}

}  // namespace rva::test
