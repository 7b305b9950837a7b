// DSSE envelopes: a payload of any kind with the signatures of one or more keys (Dead Simple Signing
// Envelope 1.0.2, github.com/secure-systems-lab/dsse).
#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "audit/signing_key.hpp"

namespace rva {

/// What an envelope's signatures sign (PAE).
[[nodiscard]] std::string pre_authentication_encoding(std::string_view payload_type,
                                                      std::string_view payload);

/// A signature of an envelope. It need not be of Ed25519, and need not be valid.
struct EnvelopeSignature {
  std::string key;    ///< name_with_id() of the key: a hint, not signed; may be empty
  std::string bytes;  ///< the signature

  friend bool operator==(const EnvelopeSignature&, const EnvelopeSignature&) = default;
};

/// An envelope. Do not rely on its content before signers_of() has returned a trusted key.
struct Envelope {
  std::string payload_type;                   ///< UTF-8
  std::string payload;                        ///< any bytes
  std::vector<EnvelopeSignature> signatures;  ///< in their order, of any number
};

/// Reads the JSON of an envelope. Unknown fields are ignored; base64 may be of either alphabet.
/// @param source where it is from, for errors
/// @throws Error when it is not an envelope
[[nodiscard]] Envelope parse_envelope(const std::string& text, const std::string& source);

/// The envelope as JSON, in the one form that RVA writes.
[[nodiscard]] std::string text_of(const Envelope& envelope);

/// Signs type and payload and appends the signature.
void sign(Envelope& envelope, const SigningKey& key);

/// Those of the keys that signed the envelope, in their order, whatever the hints of its signatures are.
[[nodiscard]] std::vector<PublicKey> signers_of(const Envelope& envelope, std::span<const PublicKey> keys);

}  // namespace rva
