// SHA-256, and bytes as text. Bytes are those of a std::string_view, whatever they stand for.
#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace rva {

/// A SHA-256 (FIPS 180-4).
using Digest = std::array<unsigned char, 32>;

/// The SHA-256 of bytes.
[[nodiscard]] Digest sha256(std::string_view bytes);

/// The SHA-256 of a file's content, which need not fit into memory.
/// @throws Error when the file is missing, unreadable or not a regular file; Interrupted
[[nodiscard]] Digest sha256_of_file(const std::filesystem::path& file);

/// The bytes of an array, such as a Digest.
template <std::size_t count>
[[nodiscard]] std::string_view bytes_of(const std::array<unsigned char, count>& array) {
  return {reinterpret_cast<const char*>(array.data()), count};
}

/// Lower-case hexadecimal digits, two for each byte.
[[nodiscard]] std::string hex_of(std::string_view bytes);

/// The reverse of hex_of() for a Digest; empty for all but 64 lower-case hexadecimal digits.
[[nodiscard]] std::optional<Digest> digest_from_hex(std::string_view text);

/// Base64 (RFC 4648, section 4), padded.
[[nodiscard]] std::string base64_of(std::string_view bytes);

/// The reverse of base64_of(); empty for any text that it does not write.
[[nodiscard]] std::optional<std::string> bytes_from_base64(std::string_view text);

/// The same for base64 that may also be of the URL-safe alphabet (RFC 4648, section 5).
[[nodiscard]] std::optional<std::string> bytes_from_either_base64(std::string_view text);

/// The same for a Digest.
[[nodiscard]] std::optional<Digest> digest_from_base64(std::string_view text);

}  // namespace rva
