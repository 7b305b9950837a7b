#include "robot/robot_lines.hpp"

#include <fmt/format.h>

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

template <typename Number>
bool parse(std::string_view word, Number& number) {
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), number);
  return error == std::errc() && end == word.data() + word.size();
}

using Words = std::vector<std::string_view>;

std::optional<RobotLine> parse_ready(const Words& words) {
  ReadyLine ready;
  double speed = 0.0;
  if (words.size() != 8 || !parse(words[1], ready.protocol)) return std::nullopt;
  ready.firmware = words[2];
  AxisLimits& pan = ready.limits.pan;
  AxisLimits& tilt = ready.limits.tilt;
  const bool sound = parse(words[3], pan.min_deg) && parse(words[4], pan.max_deg) &&
                     parse(words[5], tilt.min_deg) && parse(words[6], tilt.max_deg) && parse(words[7], speed);
  if (!sound) return std::nullopt;
  return ready;
}

std::optional<RobotLine> parse_answer(const Words& words) {
  AnswerLine answer;
  const bool refused = words[0] == "NAK";
  if (words.size() != (refused ? 3U : 2U) || !parse(words[1], answer.number)) return std::nullopt;
  if (refused) answer.refusal = words[2];
  return answer;
}

bool parse_position(std::string_view angle, std::string_view age, std::optional<JointPosition>& position) {
  if (angle == "-" && age == "-") return true;
  JointPosition told;
  double age_ms = 0.0;
  if (!parse(angle, told.deg) || !parse(age, age_ms)) return false;
  told.age_s = age_ms / 1000.0;
  position = told;
  return true;
}

std::optional<RobotLine> parse_positions(const Words& words) {
  PositionsLine positions;
  if (words.size() != 7 || !parse_position(words[2], words[3], positions.pan) ||
      !parse_position(words[4], words[5], positions.tilt))
    return std::nullopt;
  positions.state = words[6];
  return positions;
}

std::optional<RobotLine> parse_status(std::string_view text, const Words& words) {
  if (words.size() != 6) return std::nullopt;
  return StatusLine{std::string(words[1]), std::string(text.substr(words[0].size() + words[1].size() + 2))};
}

std::optional<RobotLine> parse_frame(std::string_view frame) {
  constexpr std::size_t check_length = 5;  // * and four digits
  if (frame.size() <= check_length || frame[frame.size() - check_length] != '*') return std::nullopt;
  const std::string_view text = frame.substr(0, frame.size() - check_length);
  if (frame.substr(text.size() + 1) != fmt::format("{:04X}", checksum(text))) return std::nullopt;
  const Words words = words_of(text);
  if (words[0] == "READY") return parse_ready(words);
  if (words[0] == "ACK" || words[0] == "NAK") return parse_answer(words);
  if (words[0] == "POS") return parse_positions(words);
  if (words[0] == "STAT") return parse_status(text, words);
  return std::nullopt;
}

// Two decimals each, as the thesis' firmware prints them: a line whose beginning was lost has fewer.
std::optional<RobotLine> parse_bare(std::string_view line) {
  const std::size_t cross = line.find('x');
  if (cross == std::string_view::npos) return std::nullopt;
  BarePositionsLine positions;
  for (const auto& [text, deg] : {std::pair{line.substr(0, cross), &positions.joints.pan_deg},
                                  std::pair{line.substr(cross + 1), &positions.joints.tilt_deg}}) {
    const std::size_t point = text.find('.');
    if (point == std::string_view::npos || text.size() != point + 3 || !parse(text, *deg))
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

std::optional<RobotLine> parse_robot_line(std::string_view line) {
  if (line.empty()) return std::nullopt;
  return line[0] == '$' ? parse_frame(line.substr(1)) : parse_bare(line);
}

}  // namespace rva
