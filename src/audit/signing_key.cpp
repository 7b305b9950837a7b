#include "audit/signing_key.hpp"

#include <fmt/format.h>
#include <sodium.h>

#include <algorithm>
#include <array>
#include <cassert>
#include <optional>
#include <utility>

#include "audit/digest.hpp"
#include "core/error.hpp"
#include "core/path_text.hpp"

namespace rva {
namespace {

constexpr char ed25519 = '\1';  // signature type of c2sp.org/signed-note
constexpr std::size_t most_name_bytes = 200;

// The characters beyond ASCII that Unicode counts as white space.
constexpr std::array<std::string_view, 19> spaces{
    "\u0085", "\u00a0", "\u1680", "\u2000", "\u2001", "\u2002", "\u2003", "\u2004", "\u2005", "\u2006",
    "\u2007", "\u2008", "\u2009", "\u200a", "\u2028", "\u2029", "\u202f", "\u205f", "\u3000"};

const unsigned char* data_of(std::string_view bytes) {
  return reinterpret_cast<const unsigned char*>(bytes.data());
}

std::string typed_key(const PublicKey& key) { return ed25519 + std::string(bytes_of(key.bytes)); }

std::optional<PublicKey> parsed(std::string_view text) {
  const std::size_t first = text.find('+');
  const std::size_t second = text.find('+', first + 1);  // a plus sign after it belongs to the base64
  if (first == text.npos || second == text.npos) return std::nullopt;
  const std::optional<std::string> typed = bytes_from_base64(text.substr(second + 1));
  PublicKey key;
  key.name = text.substr(0, first);
  if (!is_key_name(key.name) || !typed || typed->size() != 1 + key.bytes.size() || typed->front() != ed25519)
    return std::nullopt;
  std::copy(typed->begin() + 1, typed->end(), key.bytes.begin());
  if (verifier_key(key) != text) return std::nullopt;
  return key;
}

}  // namespace

bool is_key_name(std::string_view name) {
  const auto is_allowed = [](char character) {
    const auto code = static_cast<unsigned char>(character);
    return code > 0x20 && code != 0x7f && character != '+';
  };
  return !name.empty() && name.size() <= most_name_bytes && is_utf8(name) &&
         std::all_of(name.begin(), name.end(), is_allowed) &&
         std::none_of(spaces.begin(), spaces.end(),
                      [&](std::string_view space) { return name.find(space) != name.npos; });
}

std::uint32_t key_id(const PublicKey& key) {
  const Digest digest = sha256(key.name + '\n' + typed_key(key));
  std::uint32_t id = 0;
  for (std::size_t i = 0; i < sizeof id; ++i) id = id << 8U | digest[i];
  return id;
}

std::string name_with_id(const PublicKey& key) { return fmt::format("{}+{:08x}", key.name, key_id(key)); }

std::string verifier_key(const PublicKey& key) { return name_with_id(key) + '+' + base64_of(typed_key(key)); }

PublicKey public_key_from(std::string_view text, const std::string& source) {
  if (std::optional<PublicKey> key = parsed(text)) return *std::move(key);
  throw Error(source, "is not a public Ed25519 key of the form NAME+ID+BASE64, or it is damaged",
              "get the key again from the person that it belongs to");
}

bool is_signature(const Signature& signature, std::string_view message, const PublicKey& key) {
  return crypto_sign_verify_detached(signature.data(), data_of(message), message.size(), key.bytes.data()) ==
         0;
}

bool is_signature(std::string_view signature, std::string_view message, const PublicKey& key) {
  Signature array{};
  if (signature.size() != array.size()) return false;
  std::copy(signature.begin(), signature.end(), array.begin());
  return is_signature(array, message, key);
}

SigningKey::SigningKey(std::string name, const Seed& seed) : seed_(seed) {
  assert(is_key_name(name));
  public_key_.name = std::move(name);
  std::array<unsigned char, crypto_sign_SECRETKEYBYTES> secret{};
  crypto_sign_seed_keypair(public_key_.bytes.data(), secret.data(), seed_.data());
  sodium_memzero(secret.data(), secret.size());
}

SigningKey SigningKey::generate(std::string name) {
  if (sodium_init() < 0) throw Error("keys", "the system provides no random numbers", "restart the computer");
  Seed seed{};
  randombytes_buf(seed.data(), seed.size());
  SigningKey key(std::move(name), seed);
  sodium_memzero(seed.data(), seed.size());
  return key;
}

SigningKey::~SigningKey() { sodium_memzero(seed_.data(), seed_.size()); }

Signature SigningKey::sign(std::string_view message) const {
  std::array<unsigned char, crypto_sign_PUBLICKEYBYTES> public_bytes{};
  std::array<unsigned char, crypto_sign_SECRETKEYBYTES> secret{};
  crypto_sign_seed_keypair(public_bytes.data(), secret.data(), seed_.data());
  Signature signature{};
  crypto_sign_detached(signature.data(), nullptr, data_of(message), message.size(), secret.data());
  sodium_memzero(secret.data(), secret.size());
  return signature;
}

}  // namespace rva
