// Numbers as text and back, without a heap and without floating point.
#ifndef RVA_ROBOT_TEXT_H
#define RVA_ROBOT_TEXT_H

#include <stdint.h>

namespace rva_robot {

/// Hundredths of a number with up to two decimals: "-10.5" is -1050. At most three digits before the point.
/// @return false where `text` is no such number, in whole; `value` is as it was then
bool parse_hundredths(const char* text, uint8_t length, int16_t& value);

/// A line that is put together in place; what does not fit makes it unsound.
class Line {
 public:
  static constexpr uint8_t capacity = 64;

  Line& text(const char* text);
  Line& number(uint32_t number);
  Line& integer(int16_t number);
  Line& hex(uint16_t value, uint8_t digits);
  /// As a decimal number: 2 decimals of hundredths, 1 of tenths.
  Line& decimal(int32_t value, uint8_t decimals);
  Line& character(char character);

  /// Puts `$` before it and checksum and end behind it.
  void close_frame();

  const char* data() const { return data_; }
  uint8_t size() const { return size_; }
  /// All of it fitted.
  bool sound() const { return sound_; }

 private:
  char data_[capacity] = {};
  uint8_t size_ = 0;
  bool sound_ = true;
};

/// CRC-16/CCITT-FALSE.
uint16_t crc16(const char* text, uint8_t length);

}  // namespace rva_robot

#endif
