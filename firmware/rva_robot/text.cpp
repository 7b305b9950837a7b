#include "text.h"

namespace rva_robot {
namespace {

bool is_digit(char character) { return character >= '0' && character <= '9'; }

// The number that begins at `from`, and the index of its end. Reads at most five digits, which is enough to
// recognise a number as too long.
int32_t digits_from(const char* text, uint8_t from, uint8_t length, uint8_t& end) {
  int32_t number = 0;
  for (end = from; end < length && end - from < 5 && is_digit(text[end]); ++end)
    number = 10 * number + (text[end] - '0');
  return number;
}

char hex_digit(uint8_t value) { return static_cast<char>(value < 10 ? '0' + value : 'A' + (value - 10)); }

}  // namespace

bool parse_hundredths(const char* text, uint8_t length, int16_t& value) {
  const bool negative = length > 0 && text[0] == '-';
  const uint8_t first = negative ? 1 : 0;
  uint8_t end = 0;
  const int32_t whole = digits_from(text, first, length, end);
  if (end < first + 1 || end > first + 3) return false;
  int32_t hundredths = 100 * whole;
  if (end < length) {
    if (text[end] != '.') return false;
    const uint8_t point = end;
    const int32_t part = digits_from(text, static_cast<uint8_t>(point + 1), length, end);
    const uint8_t decimals = static_cast<uint8_t>(end - point - 1);
    if (decimals < 1 || decimals > 2) return false;
    hundredths += decimals == 1 ? 10 * part : part;
  }
  if (end < length || hundredths > INT16_MAX) return false;
  value = static_cast<int16_t>(negative ? -hundredths : hundredths);
  return true;
}

Line& Line::character(char character) {
  if (size_ < capacity)
    data_[size_++] = character;
  else
    sound_ = false;
  return *this;
}

Line& Line::text(const char* text) {
  for (; *text != '\0'; ++text) character(*text);
  return *this;
}

Line& Line::number(uint32_t number) {
  uint32_t worth = 1;
  while (number / worth >= 10) worth *= 10;
  for (; worth > 0; worth /= 10) character(static_cast<char>('0' + number / worth % 10));
  return *this;
}

Line& Line::integer(int16_t number) {
  if (number < 0) character('-');
  return this->number(static_cast<uint32_t>(number < 0 ? -static_cast<int32_t>(number) : number));
}

Line& Line::hex(uint16_t value, uint8_t digits) {
  while (digits-- > 0) character(hex_digit((value >> (4 * digits)) & 0xF));
  return *this;
}

Line& Line::decimal(int32_t value, uint8_t decimals) {
  if (value < 0) character('-');
  const uint32_t size = static_cast<uint32_t>(value < 0 ? -value : value);
  const uint8_t worth = decimals == 2 ? 100 : 10;
  number(size / worth).character('.');
  if (decimals == 2) character(static_cast<char>('0' + size / 10 % 10));
  return character(static_cast<char>('0' + size % 10));
}

void Line::close_frame() {
  const uint16_t crc = crc16(data_, size_);
  if (size_ == capacity) {
    sound_ = false;
    return;
  }
  for (uint8_t i = size_; i > 0; --i) data_[i] = data_[i - 1];
  data_[0] = '$';
  ++size_;
  character('*').hex(crc, 4).text("\r\n");
}

uint16_t crc16(const char* text, uint8_t length) {
  uint16_t crc = 0xFFFF;
  for (uint8_t i = 0; i < length; ++i) {
    crc ^= static_cast<uint16_t>(static_cast<uint8_t>(text[i]) << 8);
    for (uint8_t bit = 0; bit < 8; ++bit)
      crc = static_cast<uint16_t>((crc & 0x8000) != 0 ? (crc << 1) ^ 0x1021 : crc << 1);
  }
  return crc;
}

}  // namespace rva_robot
