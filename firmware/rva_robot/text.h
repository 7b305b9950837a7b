// Conversion between numbers and text, without heap or floating point.
#ifndef RVA_ROBOT_TEXT_H
#define RVA_ROBOT_TEXT_H

#include <stdint.h>

namespace rva_robot {

/// Parses a number with at most three digits before the point and at most two decimals into hundredths:
/// "-10.5" becomes -1050.
/// @return false if the whole text is not such a number; `value` is unchanged then
bool parse_hundredths(const char* text, uint8_t length, int16_t& value);

/// Builds a line in a fixed buffer; a line that does not fit becomes invalid, see sound().
class Line {
 public:
  static constexpr uint8_t capacity = 64;

  Line& text(const char* text);
  Line& number(uint32_t number);
  Line& integer(int16_t number);
  Line& hex(uint16_t value, uint8_t digits);
  /// Appends a decimal number. `value` is in hundredths for 2 decimals, in tenths for 1.
  Line& decimal(int32_t value, uint8_t decimals);
  Line& character(char character);

  /// Puts `$` before the line, and the checksum and the end of the line after it.
  void close_frame();

  const char* data() const { return data_; }
  uint8_t size() const { return size_; }
  /// Whether the whole line fitted into the buffer.
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
