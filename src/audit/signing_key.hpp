// Named Ed25519 keys (RFC 8032), public ones as the verifier keys of signed notes (c2sp.org/signed-note).
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>

namespace rva {

/// An Ed25519 signature.
using Signature = std::array<unsigned char, 64>;

/// Whether a name may be that of a key: UTF-8 of 1 to 200 bytes without spaces, plus signs and control
/// characters.
[[nodiscard]] bool is_key_name(std::string_view name);

/// A key by which anyone checks a signature.
struct PublicKey {
  std::string name;                       ///< is_key_name()
  std::array<unsigned char, 32> bytes{};  ///< the point, as RFC 8032 encodes it

  friend bool operator==(const PublicKey&, const PublicKey&) = default;
};

/// A short number by which signatures name their key, no proof of anything: the first four bytes of the
/// SHA-256 of name, line feed, 0x01 and key.
[[nodiscard]] std::uint32_t key_id(const PublicKey& key);

/// "NAME+c74f20a3": the name with the key_id().
[[nodiscard]] std::string name_with_id(const PublicKey& key);

/// "NAME+c74f20a3+BASE64", a verifier key of signed notes, without a line feed.
[[nodiscard]] std::string verifier_key(const PublicKey& key);

/// Reads a verifier_key().
/// @param source where the text is from, for errors
/// @throws Error when it is none, not of Ed25519, or damaged: its id does not fit
[[nodiscard]] PublicKey public_key_from(std::string_view text, const std::string& source);

/// Whether a signature of a message was made with the private half of this key.
[[nodiscard]] bool is_signature(const Signature& signature, std::string_view message, const PublicKey& key);

/// @overload
/// @param signature bytes of any number
[[nodiscard]] bool is_signature(std::string_view signature, std::string_view message, const PublicKey& key);

/// A key that signs. Its secret is wiped from memory when it is destroyed.
class SigningKey {
 public:
  using Seed = std::array<unsigned char, 32>;  ///< what the key is derived from (RFC 8032)

  /// @param name is_key_name()
  SigningKey(std::string name, const Seed& seed);
  /// A new key from the system's random numbers.
  [[nodiscard]] static SigningKey generate(std::string name);
  SigningKey(const SigningKey&) = default;
  SigningKey& operator=(const SigningKey&) = default;
  ~SigningKey();

  /// The public half.
  [[nodiscard]] const PublicKey& public_key() const { return public_key_; }
  /// The private half.
  [[nodiscard]] const Seed& seed() const { return seed_; }
  /// The same for the same message, always.
  [[nodiscard]] Signature sign(std::string_view message) const;

 private:
  PublicKey public_key_;
  Seed seed_{};
};

}  // namespace rva
