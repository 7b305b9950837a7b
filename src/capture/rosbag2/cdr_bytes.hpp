// Deserialises values of ROS 2: CDR (OMG DDS-XTypes 7.4.1, as Fast-CDR 1.0 writes it).
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

#include "core/error.hpp"

namespace rva {

/// Takes values from the front of a message: little endian, numbers aligned to their size (counted from the
/// end of the four bytes that state the encoding), texts and lists preceded by a length of 32 bits. The bytes
/// must outlive this object and the texts and spans that it returns.
class CdrBytes {
 public:
  /// @param source the file's name, for errors
  /// @throws Error when the message has another encoding
  CdrBytes(std::span<const std::byte> message, std::string_view source) : source_(source) {
    constexpr std::size_t encapsulation_bytes = 4;
    constexpr std::byte plain_little_endian{1};
    if (message.size() < encapsulation_bytes || message[0] != std::byte{0} ||
        message[1] != plain_little_endian)
      throw Error(std::string(source), "a message is not encoded as little-endian CDR", "record it again");
    bytes_ = message.subspan(encapsulation_bytes);
  }

  /// Takes a number of the given type. @throws Error when fewer bytes are left; so do all functions below
  template <typename Number>
  [[nodiscard]] Number number() {
    at_ = (at_ + sizeof(Number) - 1) / sizeof(Number) * sizeof(Number);
    Number value;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }

  /// Takes a list of bytes.
  [[nodiscard]] std::span<const std::byte> list_of_bytes() { return take(number<std::uint32_t>()); }

  /// A text without its terminating zero.
  [[nodiscard]] std::string_view text() {
    const auto bytes = list_of_bytes();
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    return text.substr(0, text.find('\0'));
  }

 private:
  std::span<const std::byte> take(std::size_t count) {
    if (at_ > bytes_.size() || count > bytes_.size() - at_)
      throw Error(std::string(source_), "a message ends early", "record it again");
    const auto taken = bytes_.subspan(at_, count);
    at_ += count;
    return taken;
  }

  std::span<const std::byte> bytes_;
  std::size_t at_ = 0;
  std::string_view source_;
};

}  // namespace rva
