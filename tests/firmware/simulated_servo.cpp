#include "tests/firmware/simulated_servo.hpp"

#include <algorithm>
#include <cmath>

namespace rva::test {
namespace {

constexpr double deg_a_count = 0.325;
constexpr double s_a_play = 0.0112;
constexpr std::uint8_t lets_go = 0x01 | 0x04 | 0x10 | 0x20;
constexpr double sag_deg_s = 30.0;  // without torque, towards the stop below
constexpr double sags_to_deg = -120.0;

std::uint8_t check_of(const std::vector<std::uint8_t>& packet) {
  std::uint8_t check = packet[2] ^ packet[3] ^ packet[4];
  for (std::size_t i = 7; i < packet.size(); ++i) check ^= packet[i];
  return check;
}

bool is_sound(const std::vector<std::uint8_t>& packet) {
  if (packet.size() < 7 || packet[0] != 0xFF || packet[1] != 0xFF || packet[2] != packet.size()) return false;
  const std::uint8_t check = check_of(packet);
  return packet[5] == (check & 0xFE) && packet[6] == (~check & 0xFE);
}

std::vector<std::uint8_t> reply_of(std::uint8_t id, std::uint8_t command,
                                   const std::vector<std::uint8_t>& data) {
  std::vector<std::uint8_t> reply{
      0xFF, 0xFF, static_cast<std::uint8_t>(7 + data.size()), id, static_cast<std::uint8_t>(command + 0x40),
      0,    0};
  for (const std::uint8_t byte : data) reply.push_back(byte);
  const std::uint8_t check = check_of(reply);
  reply[5] = check & 0xFE;
  reply[6] = ~check & 0xFE;
  return reply;
}

}  // namespace

SimulatedServo::SimulatedServo(std::uint8_t id, double angle_deg, bool torque)
    : id_(id), eep_id_(id), angle_deg_(angle_deg), hold_deg_(angle_deg) {
  start();
  ram_[52] = torque ? 0x60 : 0;
}

void SimulatedServo::start() {
  id_ = eep_id_;
  move_.reset();
  ram_.fill(0);
  ram_[1] = 1;
  ram_[8] = 25;
  ram_[9] = 45;
  ram_[54] = 162;  // 12 V
  ram_[55] = 140;
}

std::optional<std::vector<std::uint8_t>> SimulatedServo::take(const std::vector<std::uint8_t>& packet) {
  if (!is_sound(packet) || packet[3] != id_) return std::nullopt;
  const std::uint8_t command = packet[4];
  const std::uint8_t* const data = packet.data() + 7;
  const std::size_t length = packet.size() - 7;
  if (command == 7 && length == 0) return reply_of(id_, command, {status_error(), status_detail()});
  if (command == 4 && length == 2) {
    std::vector<std::uint8_t> answer{data[0], data[1]};
    for (std::uint8_t i = 0; i < data[1]; ++i) answer.push_back(read(static_cast<std::uint8_t>(data[0] + i)));
    answer.push_back(status_error());
    answer.push_back(status_detail());
    return reply_of(id_, command, answer);
  }
  obey(command, data, length);
  return std::nullopt;
}

void SimulatedServo::obey(std::uint8_t command, const std::uint8_t* data, std::size_t length) {
  if (command == 1 && length == 3 && data[0] == 6 && data[1] == 1) {
    eep_id_ = data[2];
  } else if (command == 9 && length == 0) {
    start();
  } else if (command == 3 && length >= 2 && length == 2U + data[1]) {
    for (std::uint8_t i = 0; i < data[1]; ++i) write(static_cast<std::uint8_t>(data[0] + i), data[2 + i]);
  } else if (command == 5 && length == 5 && data[3] == id_) {
    jog(data);
  }
}

void SimulatedServo::advance(double seconds) {
  let_go_at_fault();
  const double before_deg = angle_deg_;
  if (!torque()) {
    move_.reset();
    angle_deg_ = std::max(sags_to_deg, angle_deg_ - sag_deg_s * seconds);
    hold_deg_ = angle_deg_;
  } else if (move_) {
    move_->since_s += seconds;
    const Move& move = *move_;
    const double t = std::min(move.since_s, move.duration_s);
    const double a = move.acceleration_s;
    const double distance_deg = move.to_deg - move.from_deg;
    const double fastest_deg_s = distance_deg / (move.duration_s - a);
    double done_deg = distance_deg;
    if (t < a)
      done_deg = 0.5 * fastest_deg_s * t * t / a;
    else if (t < move.duration_s - a)
      done_deg = fastest_deg_s * (t - 0.5 * a);
    else if (a > 0.0)
      done_deg = distance_deg - 0.5 * fastest_deg_s * (move.duration_s - t) * (move.duration_s - t) / a;
    angle_deg_ = move.from_deg + done_deg;
    hold_deg_ = angle_deg_;
    if (move.since_s >= move.duration_s) move_.reset();
  } else {
    angle_deg_ = hold_deg_;
  }
  speed_deg_s_ = (angle_deg_ - before_deg) / seconds;
}

std::uint8_t SimulatedServo::status_error() const { return ram_[48] | faults.error; }

std::uint8_t SimulatedServo::status_detail() const {
  return static_cast<std::uint8_t>((move_ ? 0x01 : 0x02) | (torque() ? 0x40 : 0x00));
}

void SimulatedServo::let_go_at_fault() {
  ram_[48] |= faults.error;
  if ((ram_[48] & lets_go) != 0) ram_[52] = 0;
}

void SimulatedServo::write(std::uint8_t address, std::uint8_t value) {
  if (address == 52 && value == 0x60 && !torque()) hold_deg_ = angle_deg_;
  ram_[address] = value;
}

std::uint8_t SimulatedServo::read(std::uint8_t address) const {
  const auto count = static_cast<int>(std::lround(angle_deg_ / deg_a_count)) + 512;
  if (address == 58) return static_cast<std::uint8_t>(count & 0xFF);
  if (address == 59) return static_cast<std::uint8_t>((count >> 8 & 0x03) | faults.high_bits);
  return ram_[address];
}

void SimulatedServo::jog(const std::uint8_t* data) {
  if (!torque()) return;
  if ((data[2] & 0x01) != 0) {
    move_.reset();
    hold_deg_ = angle_deg_;
    return;
  }
  const int count = data[0] | (data[1] & 0x03) << 8;
  const double duration_s = std::max<int>(data[4], 1) * s_a_play;
  const double acceleration_s = std::min(duration_s * ram_[8] / 100.0, ram_[9] * s_a_play);
  move_ = Move{angle_deg_, (count - 512) * deg_a_count, duration_s, acceleration_s, 0.0};
}

}  // namespace rva::test
