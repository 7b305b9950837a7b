#include "audit/digest.hpp"

#include <sodium.h>

#include <algorithm>
#include <cstddef>

#include "core/file.hpp"
#include "core/interrupt.hpp"

namespace rva {
namespace {

const unsigned char* data_of(std::string_view bytes) {
  return reinterpret_cast<const unsigned char*>(bytes.data());
}

std::optional<std::string> decoded(std::string_view text, int variant) {
  std::string bytes(text.size() / 4 * 3, '\0');
  std::size_t count = 0;
  if (sodium_base642bin(reinterpret_cast<unsigned char*>(bytes.data()), bytes.size(), text.data(),
                        text.size(), nullptr, &count, nullptr, variant) != 0)
    return std::nullopt;
  bytes.resize(count);
  return bytes;
}

}  // namespace

Digest sha256(std::string_view bytes) {
  Digest digest{};
  crypto_hash_sha256(digest.data(), data_of(bytes), bytes.size());
  return digest;
}

Digest sha256_of_file(const std::filesystem::path& file) {
  constexpr std::size_t chunk_bytes = 1U << 20U;
  const OpenFile open(file);
  crypto_hash_sha256_state state;
  crypto_hash_sha256_init(&state);
  for (std::uint64_t at = 0;; at += chunk_bytes) {
    throw_if_interrupted();
    const std::vector<std::byte> chunk = open.read(at, chunk_bytes);
    crypto_hash_sha256_update(&state, reinterpret_cast<const unsigned char*>(chunk.data()), chunk.size());
    if (chunk.size() < chunk_bytes) break;
  }
  Digest digest{};
  crypto_hash_sha256_final(&state, digest.data());
  return digest;
}

std::string hex_of(std::string_view bytes) {
  std::string text(2 * bytes.size() + 1, '\0');
  sodium_bin2hex(text.data(), text.size(), data_of(bytes), bytes.size());
  text.pop_back();  // the terminating zero
  return text;
}

std::optional<Digest> digest_from_hex(std::string_view text) {
  Digest digest{};
  std::size_t count = 0;
  if (text.size() != 2 * digest.size() ||
      sodium_hex2bin(digest.data(), digest.size(), text.data(), text.size(), nullptr, &count, nullptr) != 0 ||
      hex_of(bytes_of(digest)) != text)
    return std::nullopt;
  return digest;
}

std::string base64_of(std::string_view bytes) {
  std::string text(sodium_base64_encoded_len(bytes.size(), sodium_base64_VARIANT_ORIGINAL), '\0');
  sodium_bin2base64(text.data(), text.size(), data_of(bytes), bytes.size(), sodium_base64_VARIANT_ORIGINAL);
  text.pop_back();  // the terminating zero
  return text;
}

std::optional<std::string> bytes_from_base64(std::string_view text) {
  std::optional<std::string> bytes = decoded(text, sodium_base64_VARIANT_ORIGINAL);
  if (bytes && base64_of(*bytes) != text) return std::nullopt;
  return bytes;
}

std::optional<std::string> bytes_from_either_base64(std::string_view text) {
  if (std::optional<std::string> bytes = bytes_from_base64(text)) return bytes;
  return decoded(text, sodium_base64_VARIANT_URLSAFE);
}

std::optional<Digest> digest_from_base64(std::string_view text) {
  const std::optional<std::string> bytes = bytes_from_base64(text);
  Digest digest{};
  if (!bytes || bytes->size() != digest.size()) return std::nullopt;
  std::copy(bytes->begin(), bytes->end(), digest.begin());
  return digest;
}

}  // namespace rva
