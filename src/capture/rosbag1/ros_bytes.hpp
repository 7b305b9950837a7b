// Deserialises values of ROS 1 (wiki.ros.org/Bags/Format/2.0, wiki.ros.org/msg).
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

#include "core/error.hpp"

namespace rva {

/// Takes values from the front of bytes: little endian, no padding, texts and lists preceded by a length of
/// 32 bits. The bytes must outlive this object and the texts and spans that it returns.
class RosBytes {
 public:
  /// @param source the file's name, for errors
  RosBytes(std::span<const std::byte> bytes, std::string_view source) : rest_(bytes), source_(source) {}

  /// Takes bytes as they are. @throws Error when fewer bytes are left; so do all functions below
  [[nodiscard]] std::span<const std::byte> take(std::size_t count) {
    if (count > rest_.size()) throw Error(std::string(source_), "a message ends early", "record it again");
    const auto taken = rest_.first(count);
    rest_ = rest_.subspan(count);
    return taken;
  }

  /// Takes a number of the given type.
  template <typename Number>
  [[nodiscard]] Number number() {
    Number value;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }

  /// Takes a list of bytes.
  [[nodiscard]] std::span<const std::byte> list_of_bytes() { return take(number<std::uint32_t>()); }

  /// Takes a text.
  [[nodiscard]] std::string_view text() { return as_text(list_of_bytes()); }

  /// All remaining bytes as a text.
  [[nodiscard]] std::string_view rest() { return as_text(take(left())); }

  /// A time, stored as seconds and nanoseconds of 32 bits each.
  [[nodiscard]] std::uint64_t time_ns() {
    const std::uint64_t seconds = number<std::uint32_t>();
    return seconds * 1'000'000'000ULL + number<std::uint32_t>();
  }

  /// Number of bytes that remain.
  [[nodiscard]] std::size_t left() const { return rest_.size(); }

 private:
  static std::string_view as_text(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }

  std::span<const std::byte> rest_;
  std::string_view source_;
};

}  // namespace rva
