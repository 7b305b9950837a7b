#include "robot/robot_lines.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <boost/crc.hpp>
#include <charconv>
#include <vector>

namespace rva {
namespace {

// CRC-16/CCITT-FALSE.
std::uint16_t checksum(std::string_view text) {
  boost::crc_optimal<16, 0x1021, 0xFFFF, 0, false, false> crc;
  crc.process_bytes(text.data(), text.size());
  return static_cast<std::uint16_t>(crc.checksum());
}

std::vector<std::string_view> words_of(std::string_view text) {
  std::vector<std::string_view> words;
  for (std::size_t begin = 0; begin <= text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    words.push_back(text.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

bool holds_only(std::string_view word, std::string_view characters) {
  return !word.empty() && word.find_first_not_of(characters) == std::string_view::npos;
}

constexpr std::string_view digits = "0123456789";
constexpr std::string_view capitals = "ABCDEFGHIJKLMNOPQRSTUVWXYZ";

// A number of digits only, up to `most`.
template <typename Number>
bool parse_count(std::string_view word, Number& number, Number most) {
  if (!holds_only(word, digits)) return false;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && number <= most;
}

// A number with up to two decimals, as the protocol defines it: no exponent, no infinity, no NaN.
bool parse_decimal(std::string_view word, double& number, double least, double most) {
  const std::string_view magnitude = word.substr(word.starts_with('-') ? 1 : 0);
  const std::size_t point = std::min(magnitude.find('.'), magnitude.size());
  const std::string_view decimals = magnitude.substr(point);
  constexpr std::size_t most_decimals = 2;
  if (!holds_only(magnitude.substr(0, point), digits) || decimals.size() > most_decimals + 1 ||
      (!decimals.empty() && !holds_only(decimals.substr(1), digits)))
    return false;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && number >= least && number <= most;
}

// A servo can be turned beyond the limits of its moves by hand, but not beyond this.
constexpr double most_measured_deg = 180.0;

bool parse_limits(std::string_view min, std::string_view max, const AxisLimits& allowed, AxisLimits& limits) {
  return parse_decimal(min, limits.min_deg, allowed.min_deg, allowed.max_deg) &&
         parse_decimal(max, limits.max_deg, allowed.min_deg, allowed.max_deg) &&
         limits.min_deg < limits.max_deg;
}

using Words = std::vector<std::string_view>;

// Limits and speeds beyond those of supported robots are rejected.
std::optional<RobotLine> parse_ready(const Words& words) {
  constexpr RobotLimits allowed;
  constexpr int most_protocol = 1000;
  constexpr double most_speed_deg_s = 90.0;
  ReadyLine ready;
  double speed_deg_s = 0.0;
  if (words.size() != 8 || !parse_count(words[1], ready.protocol, most_protocol)) return std::nullopt;
  ready.firmware = words[2];
  const bool sound = parse_limits(words[3], words[4], allowed.pan, ready.limits.pan) &&
                     parse_limits(words[5], words[6], allowed.tilt, ready.limits.tilt) &&
                     parse_decimal(words[7], speed_deg_s, 1.0, most_speed_deg_s);
  if (!sound) return std::nullopt;
  return ready;
}

std::optional<RobotLine> parse_answer(const Words& words) {
  constexpr int most_number = 255;
  AnswerLine answer;
  const bool refused = words[0] == "NAK";
  if (words.size() != (refused ? 3U : 2U) || !parse_count(words[1], answer.number, most_number))
    return std::nullopt;
  if (!refused) return answer;
  if (!holds_only(words[2], capitals)) return std::nullopt;
  answer.refusal = words[2];
  return answer;
}

bool parse_position(std::string_view angle, std::string_view age, std::optional<JointPosition>& position) {
  if (angle == "-" && age == "-") return true;
  constexpr int most_age_ms = 250;
  JointPosition reported;
  int age_ms = 0;
  if (!parse_decimal(angle, reported.deg, -most_measured_deg, most_measured_deg) ||
      !parse_count(age, age_ms, most_age_ms))
    return false;
  reported.age_s = age_ms / 1000.0;
  position = reported;
  return true;
}

std::optional<RobotLine> parse_positions(const Words& words) {
  constexpr std::array states{"START", "HOLD", "MOVE", "LOST", "FAULT"};
  PositionsLine positions;
  std::uint64_t time_ms = 0;
  if (words.size() != 7 || !parse_count(words[1], time_ms, std::uint64_t{0xFFFFFFFF}) ||
      !parse_position(words[2], words[3], positions.pan) ||
      !parse_position(words[4], words[5], positions.tilt) ||
      std::ranges::find(states, words[6]) == states.end())
    return std::nullopt;
  positions.state = words[6];
  return positions;
}

std::optional<RobotLine> parse_status(std::string_view text, const Words& words) {
  if (words.size() != 6 || (words[1] != "PAN" && words[1] != "TILT")) return std::nullopt;
  return StatusLine{std::string(words[1]), std::string(text.substr(words[0].size() + words[1].size() + 2))};
}

std::optional<RobotLine> parse_lamp(const Words& words) {
  constexpr double coldest_celsius = -20.0;
  constexpr double hottest_celsius = 100.0;
  LampState lamp;
  double celsius = 0.0;
  if (words.size() != 4 || !parse_count(words[1], lamp.percent, 100)) return std::nullopt;
  if (words[2] == "-" && words[3] == "NONE") return LampLine{};
  const bool known = parse_decimal(words[2], celsius, coldest_celsius, hottest_celsius) &&
                     (words[3] == "COOL" || words[3] == "HOT");
  if (!known) return std::nullopt;
  lamp.celsius = celsius;
  lamp.too_hot = words[3] == "HOT";
  return LampLine{lamp};
}

std::optional<RobotLine> parse_found(const Words& words) {
  constexpr std::size_t most_found = 8;
  FoundLine found;
  if (words.size() > 1 + most_found) return std::nullopt;
  for (std::size_t i = 1; i < words.size(); ++i) {
    int id = 0;
    if (!parse_count(words[i], id, greatest_servo_id) || (!found.ids.empty() && id <= found.ids.back()))
      return std::nullopt;
    found.ids.push_back(id);
  }
  return found;
}

bool is_printable(std::string_view text) {
  return std::ranges::all_of(text, [](char character) { return character >= ' ' && character <= '~'; });
}

std::optional<RobotLine> parse_frame(std::string_view frame) {
  constexpr std::size_t check_length = 5;  // * and four digits
  constexpr std::size_t most_length = 64;
  if (frame.size() <= check_length || frame.size() > most_length || !is_printable(frame) ||
      frame[frame.size() - check_length] != '*')
    return std::nullopt;
  const std::string_view text = frame.substr(0, frame.size() - check_length);
  if (frame.substr(text.size() + 1) != fmt::format("{:04X}", checksum(text))) return std::nullopt;
  const Words words = words_of(text);
  if (words[0] == "READY") return parse_ready(words);
  if (words[0] == "ACK" || words[0] == "NAK") return parse_answer(words);
  if (words[0] == "POS") return parse_positions(words);
  if (words[0] == "FOUND") return parse_found(words);
  if (words[0] == "LAMP") return parse_lamp(words);
  if (words[0] == "STAT") return parse_status(text, words);
  return std::nullopt;
}

// Two angles with exactly two decimals each, as the thesis' firmware prints them, so that truncated lines
// are rejected.
std::optional<RobotLine> parse_bare(std::string_view line) {
  const std::size_t cross = line.find('x');
  if (cross == std::string_view::npos) return std::nullopt;
  BarePositionsLine positions;
  for (const auto& [text, deg] : {std::pair{line.substr(0, cross), &positions.joints.pan_deg},
                                  std::pair{line.substr(cross + 1), &positions.joints.tilt_deg}}) {
    const std::size_t point = text.find('.');
    if (point == std::string_view::npos || text.size() != point + 3 ||
        !parse_decimal(text, *deg, -most_measured_deg, most_measured_deg))
      return std::nullopt;
  }
  return positions;
}

}  // namespace

std::string robot_frame(int number, std::string_view body) {
  const std::string text = fmt::format("{} {}", number, body);
  return fmt::format("${}*{:04X}\n", text, checksum(text));
}

std::string move_body(const PanTilt& target) {
  return fmt::format("MOVE {:.2f} {:.2f}", target.pan_deg, target.tilt_deg);
}

std::string lamp_body(int percent) { return fmt::format("LAMP {}", percent); }

std::string name_body(int from, int to) { return fmt::format("NAME {} {}", from, to); }

std::string middle_body(int id) { return fmt::format("MIDDLE {}", id); }

std::optional<RobotLine> parse_robot_line(std::string_view line) {
  if (line.empty()) return std::nullopt;
  return line[0] == '$' ? parse_frame(line.substr(1)) : parse_bare(line);
}

}  // namespace rva
