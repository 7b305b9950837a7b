#include "host_input.h"

namespace rva_robot {
namespace {

bool belongs_to_angles(char character) {
  return (character >= '0' && character <= '9') || character == '-' || character == '.';
}

}  // namespace

void HostInput::take(uint8_t byte, uint32_t now_ms) {
  tick(now_ms);
  last_byte_ms_ = now_ms;
  const char character = static_cast<char>(byte);
  if (character == '!') {
    Command stop;
    stop.verb = Verb::stop;
    count_ = 0;  // a stop cancels all commands before it
    keep(stop);
  } else if (character == '$') {
    in_frame_ = true;
    too_long_ = false;
    size_ = 0;
  } else if (in_frame_) {
    take_in_frame(character);
  } else if (!framed_) {
    take_bare(character);
  }
}

void HostInput::tick(uint32_t now_ms) {
  if (!in_frame_ && (size_ > 0 || junk_) && now_ms - last_byte_ms_ >= silence_ends_ms) end_bare();
}

bool HostInput::next(Command& command) {
  if (count_ == 0) return false;
  command = waiting_[first_];
  first_ = static_cast<uint8_t>(1 - first_);
  --count_;
  return true;
}

void HostInput::take_in_frame(char character) {
  if (character == '\n') {
    in_frame_ = false;
    uint8_t length = size_;
    size_ = 0;
    junk_ = false;
    if (too_long_) return;
    if (length > 0 && text_[length - 1] == '\r') --length;
    const Command command = parse_frame(text_, length);
    framed_ = framed_ || command.refusal != Refusal::crc;
    keep(command);
  } else if (size_ + 2 < longest_frame) {
    text_[size_++] = character;
  } else {
    too_long_ = true;
  }
}

void HostInput::take_bare(char character) {
  if (character == '\n' || character == '\r') {
    end_bare();
  } else if (belongs_to_angles(character) && size_ < longest_bare_text) {
    text_[size_++] = character;
  } else {
    junk_ = true;
  }
}

void HostInput::end_bare() {
  Command commands[2];
  const uint8_t count = junk_ ? 0 : parse_bare(text_, size_, commands);
  size_ = 0;
  junk_ = false;
  for (uint8_t i = 0; i < count; ++i) keep(commands[i]);
}

// Keeps the last two commands that were not taken yet.
void HostInput::keep(const Command& command) {
  if (count_ == 2) {
    first_ = static_cast<uint8_t>(1 - first_);
    --count_;
  }
  waiting_[(first_ + count_) % 2] = command;
  ++count_;
}

}  // namespace rva_robot
