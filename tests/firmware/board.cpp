#include "tests/firmware/board.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "firmware/rva_robot/text.h"

namespace rva::test {
namespace {

constexpr std::int64_t reply_after_steps = 5;  // half a millisecond

// A thermistor of 10 kOhm at 25 degrees, B = 3950 K, below a resistor of 10 kOhm.
double thermistor_share(const std::optional<double>& celsius) {
  if (!celsius) return 1.0;
  const double ratio = std::exp(3950.0 * (1.0 / (*celsius + 273.15) - 1.0 / 298.15));
  return ratio / (1.0 + ratio);
}

}  // namespace

Board::Board(std::unique_ptr<Firmware> firmware, Start start, std::uint64_t seed)
    : firmware_(std::move(firmware)),
      servos_{SimulatedServo(1, start.pan_deg, start.torque),
              SimulatedServo(2, start.tilt_deg, start.torque)},
      random_(seed) {
  forget_extremes();
}

void Board::send(const std::string& bytes) {
  for (const char byte : bytes) host_queue_.push_back(static_cast<std::uint8_t>(byte));
}

int Board::send_frame(const std::string& body) {
  const int number = number_++ % 256;
  const std::string text = fmt::format("{} {}", number, body);
  send(fmt::format("${}*{:04X}\n", text,
                   rva_robot::crc16(text.data(), static_cast<std::uint8_t>(text.size()))));
  return number;
}

void Board::run_ms(double ms) {
  const auto steps = static_cast<std::int64_t>(std::lround(ms / (1000.0 * step_s)));
  for (std::int64_t i = 0; i < steps; ++i) step();
}

bool Board::run_until_ready() {
  for (int i = 0; i < 200; ++i) {
    run_ms(10);
    const bool reported = std::ranges::any_of(lines_, [](const std::string& line) {
      return line.find('x') != std::string::npos || line.find("HOLD") != std::string::npos;
    });
    if (reported && servos_[0].torque() && servos_[1].torque()) return true;
  }
  return false;
}

void Board::reset(std::unique_ptr<Firmware> firmware) {
  firmware_ = std::move(firmware);
  host_queue_.clear();
  replies_.clear();
  packet_.clear();
  bytes_.clear();
}

std::vector<std::string> Board::take_lines() { return std::exchange(lines_, {}); }

std::string Board::answer(int number) {
  const std::string suffix = fmt::format(" {}", number);
  take_lines();  // numbers come again
  for (int i = 0; i < 20; ++i) {
    run_ms(5);
    for (const std::string& line : lines_) {
      for (const char* verb : {"$ACK", "$NAK"}) {
        const std::string begin = verb + suffix;
        if (line.starts_with(begin + "*") || line.starts_with(begin + " "))
          return line.substr(1, line.find('*') - 1);
      }
    }
  }
  return "";
}

void Board::forget_extremes() {
  extremes_ = {
      0.0, servos_[0].angle_deg(), servos_[0].angle_deg(), servos_[1].angle_deg(), servos_[1].angle_deg(),
      0.0};
  last_line_ms_ = now_ms();
}

void Board::step() {
  carry_host();
  carry_servos();
  firmware_->set_thermistor(thermistor_share(lamp_celsius));
  firmware_->step();
  for (SimulatedServo& servo : servos_) servo.advance(step_s);
  watch();
  ++steps_;
}

void Board::carry_host() {
  if (!host_queue_.empty()) {
    firmware_->from_host(perhaps_flipped(host_queue_.front(), host_bit_flipped));
    host_queue_.pop_front();
  }
  for (const std::uint8_t byte : firmware_->to_host) {
    bytes_.push_back(static_cast<char>(byte));
    if (byte == '\n') {
      if (!line_.empty() && line_.back() == '\r') line_.pop_back();
      lines_.push_back(std::exchange(line_, ""));
      last_line_ms_ = now_ms();
    } else {
      line_.push_back(static_cast<char>(byte));
    }
  }
  firmware_->to_host.clear();
}

void Board::carry_servos() {
  for (const std::uint8_t byte : firmware_->to_servos) {
    packet_.push_back(perhaps_flipped(byte, servos_[0].faults.bit_flipped));
    take_packet();
  }
  firmware_->to_servos.clear();
  if (!replies_.empty() && replies_.front().step <= steps_) {
    firmware_->from_servos(replies_.front().byte);
    replies_.pop_front();
  }
}

void Board::take_packet() {
  while (!packet_.empty() && (packet_[0] != 0xFF || (packet_.size() > 1 && packet_[1] != 0xFF)))
    packet_.erase(packet_.begin());
  if (packet_.size() < 3 || packet_.size() < packet_[2]) return;
  if (packet_.size() >= 7 && packet_[4] == 5 && first_jog_ms < 0.0) first_jog_ms = now_ms();
  for (SimulatedServo& servo : servos_) hand_packet_to(servo);
  packet_.clear();
}

void Board::hand_packet_to(SimulatedServo& servo) {
  if (chance(servo.faults.packet_lost)) return;
  const auto reply = servo.take(packet_);
  if (!reply || chance(servo.faults.reply_lost)) return;
  for (const std::uint8_t byte : *reply)
    replies_.push_back({steps_ + reply_after_steps, perhaps_flipped(byte, servo.faults.bit_flipped)});
}

void Board::watch() {
  for (const SimulatedServo& servo : servos_) {
    if (servo.torque())
      extremes_.fastest_deg_s = std::max(extremes_.fastest_deg_s, std::abs(servo.speed_deg_s()));
  }
  extremes_.pan_low_deg = std::min(extremes_.pan_low_deg, servos_[0].angle_deg());
  extremes_.pan_high_deg = std::max(extremes_.pan_high_deg, servos_[0].angle_deg());
  extremes_.tilt_low_deg = std::min(extremes_.tilt_low_deg, servos_[1].angle_deg());
  extremes_.tilt_high_deg = std::max(extremes_.tilt_high_deg, servos_[1].angle_deg());
  extremes_.longest_silence_ms = std::max(extremes_.longest_silence_ms, now_ms() - last_line_ms_);
}

std::uint8_t Board::perhaps_flipped(std::uint8_t byte, double probability) {
  if (!chance(probability)) return byte;
  return static_cast<std::uint8_t>(byte ^ (1U << (random_() % 8)));
}

bool Board::chance(double probability) {
  return probability > 0.0 && std::uniform_real_distribution(0.0, 1.0)(random_) < probability;
}

}  // namespace rva::test
