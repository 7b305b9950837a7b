// Signed notes (c2sp.org/signed-note): text with the signatures of one or more keys below it.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "audit/signing_key.hpp"

namespace rva {

/// A signature line of a note. It need not be of Ed25519, and need not be valid.
struct NoteSignature {
  std::string name;      ///< of the key; is_key_name()
  std::uint32_t id = 0;  ///< key_id() of an Ed25519 key
  std::string bytes;     ///< at least one

  friend bool operator==(const NoteSignature&, const NoteSignature&) = default;
};

/// A note. Do not rely on its content before signers_of() has returned a trusted key.
struct SignedNote {
  std::string text;                       ///< UTF-8, ends with a line feed; no other control characters
  std::vector<NoteSignature> signatures;  ///< in their order; at least one if it was parsed
};

/// Reads a note. At most 100 signatures and 1 MiB are accepted.
/// @param source where it is from, for errors
/// @throws Error when it is not a note
[[nodiscard]] SignedNote parse_note(std::string_view bytes, const std::string& source);

/// The note as parse_note() reads it; every note has one text only.
[[nodiscard]] std::string text_of(const SignedNote& note);

/// Signs the text and appends the signature.
void sign(SignedNote& note, const SigningKey& key);

/// Those of the keys that signed the note, in their order. Signatures of other keys are ignored, as the
/// specification demands.
/// @throws Error when a signature by one of these keys is wrong
[[nodiscard]] std::vector<PublicKey> signers_of(const SignedNote& note, std::span<const PublicKey> keys,
                                                const std::string& source);

}  // namespace rva
