#include "outbox.h"

namespace rva_robot {

bool Outbox::put(const char* text, uint8_t length) {
  if (length > room()) return false;
  for (uint8_t i = 0; i < length; ++i) {
    const uint16_t place = static_cast<uint16_t>(first_ + size_);
    bytes_[place % capacity] = static_cast<uint8_t>(text[i]);
    ++size_;
  }
  return true;
}

void Outbox::drain(Port& port) {
  while (size_ > 0) {
    const uint8_t to_the_end = static_cast<uint8_t>(capacity - first_);
    uint8_t count = size_ < to_the_end ? size_ : to_the_end;
    const uint8_t room = port.room();
    if (room == 0) return;
    if (count > room) count = room;
    port.write(bytes_ + first_, count);
    first_ = static_cast<uint8_t>((first_ + count) % capacity);
    size_ = static_cast<uint8_t>(size_ - count);
  }
}

}  // namespace rva_robot
