#include "herkulex.h"

namespace rva_robot {
namespace {

constexpr uint8_t head = 0xFF;
constexpr uint8_t header_length = 7;
constexpr int16_t middle_count = 512;
// One count is 0.325 degrees, which is 65/2 hundredths of a degree.
constexpr int32_t halves_a_count = 65;

enum Place : uint8_t { at_size = 2, at_id = 3, at_command = 4, at_check = 5 };

uint8_t check_of(uint8_t size, uint8_t id, uint8_t command, const uint8_t* data, uint8_t length) {
  uint8_t check = static_cast<uint8_t>(size ^ id ^ command);
  for (uint8_t i = 0; i < length; ++i) check ^= data[i];
  return check;
}

}  // namespace

int16_t cdeg_of_count(uint16_t count) {
  const int32_t halves = (static_cast<int32_t>(count) - middle_count) * halves_a_count;
  return static_cast<int16_t>((halves + (halves < 0 ? -1 : 1)) / 2);
}

uint16_t count_of_cdeg(int16_t cdeg) {
  const int32_t halves = 2 * static_cast<int32_t>(cdeg);
  const int32_t half = halves_a_count / 2;
  return static_cast<uint16_t>(middle_count + (halves + (halves < 0 ? -half : half)) / halves_a_count);
}

uint8_t encode(const Packet& packet, uint8_t (&bytes)[longest_packet]) {
  const uint8_t size = static_cast<uint8_t>(header_length + packet.length);
  const uint8_t check = check_of(size, packet.id, packet.command, packet.data, packet.length);
  const uint8_t header[header_length] = {head,
                                         head,
                                         size,
                                         packet.id,
                                         packet.command,
                                         static_cast<uint8_t>(check & 0xFE),
                                         static_cast<uint8_t>(~check & 0xFE)};
  for (uint8_t i = 0; i < header_length; ++i) bytes[i] = header[i];
  for (uint8_t i = 0; i < packet.length; ++i) bytes[header_length + i] = packet.data[i];
  return size;
}

bool PacketReader::take(uint8_t byte, Packet& packet) {
  bytes_[size_++] = byte;
  while (size_ > 0) {
    const bool begins = bytes_[0] == head && (size_ < 2 || bytes_[1] == head);
    const bool sized =
        size_ <= at_size || (bytes_[at_size] >= header_length && bytes_[at_size] <= longest_packet);
    if (!begins || !sized) {
      drop_first();
      continue;
    }
    if (size_ <= at_size || size_ < bytes_[at_size]) return false;
    if (complete(packet)) {
      size_ = 0;
      return true;
    }
    drop_first();
  }
  return false;
}

bool PacketReader::complete(Packet& packet) const {
  const uint8_t length = static_cast<uint8_t>(size_ - header_length);
  const uint8_t* const data = bytes_ + header_length;
  const uint8_t check = check_of(bytes_[at_size], bytes_[at_id], bytes_[at_command], data, length);
  if (bytes_[at_check] != (check & 0xFE) || bytes_[at_check + 1] != (~check & 0xFE)) return false;
  packet = Packet();
  packet.id = bytes_[at_id];
  packet.command = bytes_[at_command];
  for (uint8_t i = 0; i < length; ++i) packet.add(data[i]);
  return true;
}

// Drops only one byte, since a valid packet may begin inside an invalid one.
void PacketReader::drop_first() {
  for (uint8_t i = 1; i < size_; ++i) bytes_[i - 1] = bytes_[i];
  --size_;
}

}  // namespace rva_robot
