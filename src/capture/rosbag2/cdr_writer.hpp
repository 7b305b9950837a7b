// Serialises values of ROS 2: CDR, little endian (the counterpart of cdr_bytes.hpp).
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace rva {

/// Appends values to a message: numbers aligned to their size, texts and lists preceded by a length of 32
/// bits.
class CdrWriter {
 public:
  /// Appends a number, after bytes of 0 up to a multiple of its size.
  template <typename Number>
  void number(Number value) {
    const std::size_t end = bytes_.size() - encapsulation_bytes;
    bytes_.resize(bytes_.size() + (sizeof(Number) - end % sizeof(Number)) % sizeof(Number));
    append(std::as_bytes(std::span(&value, 1)));
  }

  /// Appends a text with its length and a final byte of 0, which the length includes.
  void text(std::string_view text) {
    number(static_cast<std::uint32_t>(text.size() + 1));
    append(std::as_bytes(std::span(text)));
    bytes_.push_back(std::byte{0});
  }

  /// Appends a list of bytes with its length.
  void list_of_bytes(std::span<const std::byte> list) {
    number(static_cast<std::uint32_t>(list.size()));
    append(list);
  }

  /// Appends an array of fixed length, whose length is not written.
  template <typename Numbers>
  void numbers(const Numbers& values) {
    for (const auto value : values) number(value);
  }

  /// The message, which is empty afterwards.
  [[nodiscard]] std::vector<std::byte> take() { return std::move(bytes_); }

 private:
  static constexpr std::size_t encapsulation_bytes = 4;

  void append(std::span<const std::byte> bytes) { bytes_.insert(bytes_.end(), bytes.begin(), bytes.end()); }

  std::vector<std::byte> bytes_{std::byte{0}, std::byte{1}, std::byte{0}, std::byte{0}};  // little-endian CDR
};

}  // namespace rva
