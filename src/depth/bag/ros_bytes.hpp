// Values as ROS 1 lays them out in bytes (wiki.ros.org/Bags/Format/2.0, wiki.ros.org/msg).
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>

#include "core/error.hpp"

namespace rva {

/// Takes values off the front of bytes: little endian, no padding, texts and lists behind a length of 32
/// bits. The bytes must outlive it and what it gives.
class RosBytes {
 public:
  /// @param place what to call the bytes in an error
  RosBytes(std::span<const std::byte> bytes, std::string_view place) : rest_(bytes), place_(place) {}

  /// @throws Error when fewer bytes are left, and so do all below
  [[nodiscard]] std::span<const std::byte> take(std::size_t count) {
    if (count > rest_.size()) throw Error(std::string(place_), "a message ends early", "record it again");
    const auto taken = rest_.first(count);
    rest_ = rest_.subspan(count);
    return taken;
  }

  template <typename Number>
  [[nodiscard]] Number number() {
    Number value;
    std::memcpy(&value, take(sizeof value).data(), sizeof value);
    return value;
  }

  [[nodiscard]] std::span<const std::byte> list_of_bytes() { return take(number<std::uint32_t>()); }

  [[nodiscard]] std::string_view text() { return as_text(list_of_bytes()); }

  /// All that is left, as a text.
  [[nodiscard]] std::string_view rest() { return as_text(take(left())); }

  /// A time: seconds and nanoseconds, 32 bits each.
  [[nodiscard]] std::uint64_t time_ns() {
    const std::uint64_t seconds = number<std::uint32_t>();
    return seconds * 1'000'000'000ULL + number<std::uint32_t>();
  }

  [[nodiscard]] std::size_t left() const { return rest_.size(); }

 private:
  static std::string_view as_text(std::span<const std::byte> bytes) {
    return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
  }

  std::span<const std::byte> rest_;
  std::string_view place_;
};

}  // namespace rva
