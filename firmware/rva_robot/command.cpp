#include "command.h"

#include <string.h>

#include "herkulex.h"
#include "text.h"

namespace rva_robot {
namespace {

/// Splits a line into words that are separated by one space each.
class Words {
 public:
  Words(const char* text, uint8_t length) : text_(text), left_(length) {}

  bool more() const { return left_ > 0; }
  /// Returns the next word, which may be empty.
  void next(const char*& word, uint8_t& length) {
    word = text_;
    length = 0;
    while (length < left_ && word[length] != ' ') ++length;
    const uint8_t taken = static_cast<uint8_t>(length < left_ ? length + 1 : length);
    ends_in_space_ = length < left_ && left_ == taken;
    text_ += taken;
    left_ = static_cast<uint8_t>(left_ - taken);
  }
  bool number(int16_t& hundredths) {
    const char* word = nullptr;
    uint8_t length = 0;
    next(word, length);
    return parse_hundredths(word, length, hundredths);
  }
  bool ended() const { return left_ == 0 && !ends_in_space_; }

 private:
  const char* text_;
  uint8_t left_;
  bool ends_in_space_ = false;
};

bool is(const char* word, uint8_t length, const char* name) {
  return strlen(name) == length && memcmp(word, name, length) == 0;
}

bool parse_byte(const char* word, uint8_t length, uint8_t& value) {
  if (length < 1 || length > 3) return false;
  uint16_t number = 0;
  for (uint8_t i = 0; i < length; ++i) {
    if (word[i] < '0' || word[i] > '9') return false;
    number = static_cast<uint16_t>(10 * number + (word[i] - '0'));
  }
  if (number > UINT8_MAX) return false;
  value = static_cast<uint8_t>(number);
  return true;
}

bool parse_crc(const char* text, uint16_t& crc) {
  crc = 0;
  for (uint8_t i = 0; i < 4; ++i) {
    const char digit = text[i];
    uint8_t value = 0;
    if (digit >= '0' && digit <= '9')
      value = static_cast<uint8_t>(digit - '0');
    else if (digit >= 'A' && digit <= 'F')
      value = static_cast<uint8_t>(digit - 'A' + 10);
    else
      return false;
    crc = static_cast<uint16_t>((crc << 4) | value);
  }
  return true;
}

Refusal parse_move(Words& words, Command& command) {
  for (uint8_t axis = 0; axis < axes; ++axis) {
    if (!words.number(command.target_cdeg[axis])) return Refusal::form;
    command.moves[axis] = true;
  }
  if (words.more() && !words.number(command.speed_cdeg_s)) return Refusal::form;
  if (!words.ended()) return Refusal::form;
  for (uint8_t axis = 0; axis < axes; ++axis) {
    if (!within_limits(axis, command.target_cdeg[axis])) return Refusal::limit;
  }
  const bool speed = command.speed_cdeg_s >= slowest_cdeg_s && command.speed_cdeg_s <= fastest_cdeg_s;
  return speed ? Refusal::none : Refusal::limit;
}

bool parse_count(Words& words, uint8_t& count) {
  const char* word = nullptr;
  uint8_t length = 0;
  words.next(word, length);
  return parse_byte(word, length, count);
}

Refusal parse_lamp(Words& words, Command& command) {
  if (!parse_count(words, command.lamp_percent) || !words.ended()) return Refusal::form;
  return command.lamp_percent <= 100 ? Refusal::none : Refusal::limit;
}

Refusal parse_name(Words& words, Command& command) {
  if (!parse_count(words, command.servo_from) || !parse_count(words, command.servo_to) || !words.ended())
    return Refusal::form;
  const bool ids = command.servo_from <= herkulex::greatest_id && command.servo_to <= herkulex::greatest_id;
  return ids ? Refusal::none : Refusal::limit;
}

Refusal parse_middle(Words& words, Command& command) {
  if (!parse_count(words, command.servo_from) || !words.ended()) return Refusal::form;
  return command.servo_from <= herkulex::greatest_id ? Refusal::none : Refusal::limit;
}

Refusal parse_verb(Words& words, Command& command) {
  struct Name {
    const char* text;
    Verb verb;
  };
  static const Name names[] = {{"STOP", Verb::stop},
                               {"PING", Verb::ping},
                               {"CLEAR", Verb::clear},
                               {"INFO", Verb::info},
                               {"FIND", Verb::find}};
  const char* word = nullptr;
  uint8_t length = 0;
  words.next(word, length);
  if (is(word, length, "MOVE")) {
    command.verb = Verb::move;
    return parse_move(words, command);
  }
  if (is(word, length, "LAMP")) {
    command.verb = Verb::lamp;
    return parse_lamp(words, command);
  }
  if (is(word, length, "MIDDLE")) {
    command.verb = Verb::middle;
    return parse_middle(words, command);
  }
  if (is(word, length, "NAME")) {
    command.verb = Verb::name;
    return parse_name(words, command);
  }
  for (const Name& name : names) {
    if (!is(word, length, name.text)) continue;
    command.verb = name.verb;
    return words.ended() ? Refusal::none : Refusal::form;
  }
  return Refusal::form;
}

// Parses one half of a bare command: empty, or whole degrees. In commands that are run together, leading
// zeros are not allowed, or "1050" could be read as "1" and "050".
bool parse_half(const char* text, uint8_t length, bool short_way, uint8_t axis, Command& command) {
  command.moves[axis] = length > 0;
  if (length == 0) return true;
  const uint8_t digits = static_cast<uint8_t>(text[0] == '-' ? length - 1 : length);
  const char first = text[length - digits];
  if (digits < 1 || digits > 2) return false;
  if (short_way && first == '0' && (digits > 1 || digits < length)) return false;
  return parse_hundredths(text, length, command.target_cdeg[axis]);
}

bool in_reach(const Command& command) {
  for (uint8_t axis = 0; axis < axes; ++axis) {
    if (command.moves[axis] && !within_limits(axis, command.target_cdeg[axis])) return false;
  }
  return true;
}

bool parse_pair(const char* pan_text, uint8_t pan_length, const char* tilt_text, uint8_t tilt_length,
                bool short_way, Command& command) {
  command = Command();
  command.verb = Verb::move;
  return parse_half(pan_text, pan_length, short_way, pan, command) &&
         parse_half(tilt_text, tilt_length, short_way, tilt, command) &&
         (command.moves[pan] || command.moves[tilt]) && in_reach(command);
}

// Splits two commands that are run together, if there is exactly one way. `first` and `second` are the
// indices of the two points. Returns the number of commands, 2 or 0.
uint8_t parse_run_together(const char* text, uint8_t length, uint8_t first, uint8_t second,
                           Command (&commands)[2]) {
  uint8_t ways = 0;
  for (uint8_t split = static_cast<uint8_t>(first + 1); split <= second; ++split) {
    Command one;
    Command other;
    const char* const middle = text + first + 1;
    const uint8_t before = static_cast<uint8_t>(split - first - 1);
    if (!parse_pair(text, first, middle, before, true, one)) continue;
    if (!parse_pair(text + split, static_cast<uint8_t>(second - split), text + second + 1,
                    static_cast<uint8_t>(length - second - 1), true, other))
      continue;
    ++ways;
    commands[0] = one;
    commands[1] = other;
  }
  return ways == 1 ? 2 : 0;
}

}  // namespace

Command parse_frame(const char* text, uint8_t length) {
  Command command;
  command.framed = true;
  command.refusal = Refusal::crc;
  constexpr uint8_t check = 5;  // length of `*` and four digits
  uint16_t crc = 0;
  if (length < check || text[length - check] != '*' || !parse_crc(text + length - check + 1, crc) ||
      crc != crc16(text, static_cast<uint8_t>(length - check)))
    return command;
  Words words(text, static_cast<uint8_t>(length - check));
  const char* word = nullptr;
  uint8_t word_length = 0;
  words.next(word, word_length);
  command.refusal = Refusal::form;
  if (parse_byte(word, word_length, command.number)) command.refusal = parse_verb(words, command);
  return command;
}

uint8_t parse_bare(const char* text, uint8_t length, Command (&commands)[2]) {
  uint8_t points[2] = {0, 0};
  uint8_t count = 0;
  for (uint8_t i = 0; i < length; ++i) {
    if (text[i] != '.') continue;
    if (count == 2) return 0;
    points[count++] = i;
  }
  if (count == 2) return parse_run_together(text, length, points[0], points[1], commands);
  if (count == 0) return 0;
  const uint8_t point = points[0];
  return parse_pair(text, point, text + point + 1, static_cast<uint8_t>(length - point - 1), false,
                    commands[0])
             ? 1
             : 0;
}

}  // namespace rva_robot
